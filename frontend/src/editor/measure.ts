/** Live figures of elements, metres. */
import type { Lane, MapElement, Place, Side } from "./elements";
import { otherSide } from "./elements";
import { boundary, laneRing } from "./lines";
import { signedArea } from "./polygon";
import { alongLine, at, lengthOf, middle, nearestOnLine } from "./polyline";

/** Mean of the two boundaries' lengths. */
export function laneLength(lane: Lane): number {
  return (lengthOf(lane.left_lane_boundary) + lengthOf(lane.right_lane_boundary)) / 2;
}

/** Mean width: area by mean boundary length, as the rules measure it. */
export function laneWidth(lane: Lane): number {
  const length = laneLength(lane);
  return length === 0 ? 0 : Math.abs(signedArea(laneRing(lane))) / length;
}

/** From a place on one side to the other side's boundary. */
export function widthAt(lane: Lane, side: Side, place: Place): number {
  return nearestOnLine(place, boundary(lane, otherSide(side))).distance;
}

/** How long and wide an element is. */
export function measuresOf(element: MapElement): { length: number; width: number } {
  if (element.kind === "lane_segment") {
    return { length: laneLength(element.attributes), width: laneWidth(element.attributes) };
  }
  const { edge1, edge2 } = element.attributes;
  const ends = [at(edge2, 0), at(edge2, -1)].map((place) => nearestOnLine(place, edge1).distance);
  return {
    length: (lengthOf(edge1) + lengthOf(edge2)) / 2,
    width: ends.reduce((sum, far) => sum + far, 0) / ends.length,
  };
}

/** The middle of an element, for labels and for turning the map to it. */
export function centreOf(element: MapElement): Place {
  const [one, other] =
    element.kind === "lane_segment"
      ? [element.attributes.left_lane_boundary, element.attributes.right_lane_boundary]
      : [element.attributes.edge1, element.attributes.edge2];
  return middle(alongLine(one, 0.5), alongLine(other, 0.5));
}

/** Everything that changes the map. */
import { idsForCut, planCut, planJoin } from "./actions/cuts";
import { planCrossing, planDrawnLane, planLaneBeside } from "./actions/insertion";
import { planUnlink } from "./actions/links";
import { planDeletion, planIntersection, planLaneType, planMark } from "./actions/properties";
import { planReversal } from "./actions/reversal";
import { planRevert } from "./actions/revert";
import { planElementMove, planVertexInsertion, planVertexMove, planVertexRemoval } from "./actions/vertices";
import { elementOf, type MapDocument } from "./document";
import type { ElementKind } from "./elements";
import { lineOf } from "./lines";
import { paintedOtherwise } from "./partialSharing";
import type { Planned } from "./plan";
import { distance } from "./polyline";
import { NO_IDS, type Stage } from "./stage";
import type { EditorActions, Inserted, Outcome } from "./state";

const CUT =
  "Lane cut. Now change a mark, the type or the intersection of one part: only a difference makes the cut legal.";

function besidePainted(lanes: readonly number[]): string {
  const names = lanes.length === 1 ? `Lane ${lanes[0]} holds` : `Lanes ${lanes.join(" and ")} hold`;
  return `${names} this piece of line too, painted otherwise: cut there at the same place (X) and paint it alike.`;
}

type EditingActions = Omit<
  EditorActions,
  | "select"
  | "pick"
  | "pickUnderneath"
  | "hover"
  | "stepVertex"
  | "setTool"
  | "cancel"
  | "say"
  | "applyEdits"
  | "applyFix"
  | "declare"
  | "discardDraft"
  | "loadDraft"
  | "netEdits"
  | "netDraft"
  | "takeSnapshot"
  | "adoptSaved"
  | "undo"
  | "redo"
>;

export function editingActions(stage: Stage): EditingActions {
  const { store } = stage;

  const insert = async (
    kind: ElementKind,
    plan: (document: MapDocument, id: number, others: readonly number[]) => Planned,
    count = 1,
  ): Promise<Inserted> => {
    const ids: number[] = [];
    try {
      while (ids.length < count) ids.push(await stage.newId(kind));
    } catch {
      return stage.refuse(NO_IDS);
    }
    const [id = 0, ...others] = ids;
    const outcome = stage.run((document) => plan(document, id, others));
    return outcome.ok ? { ok: true, key: { kind, id } } : outcome;
  };

  const drawLane: EditorActions["drawLane"] = (line, options) =>
    insert("lane_segment", (document, id) => planDrawnLane(document, line, id, options));
  const insertCrossing: EditorActions["insertCrossing"] = (from, to, width) =>
    insert("pedestrian_crossing", (document, id) => planCrossing(document, from, to, id, width));

  const moveVertex: EditorActions["moveVertex"] = (vertex, to) =>
    stage.run((document) => planVertexMove(document, vertex, to));
  const moveElement: EditorActions["moveElement"] = (key, by) =>
    stage.run((document) => planElementMove(document, key, by));

  const finishSketch: EditorActions["finishSketch"] = async () => {
    const { sketch, tool } = stage.state;
    const points = sketch?.points ?? [];
    const [first, second] = points;
    if (first === undefined || second === undefined) return null;
    store.setState({ sketch: null });
    const done = await (tool === "draw_crossing" ? insertCrossing(first, second) : drawLane(points));
    if (done.ok) store.setState({ tool: "select" });
    else if (stage.state.sketch === null && stage.state.tool === tool) store.setState({ sketch });
    return done;
  };

  const selectedVertex = () => {
    const { selection, current } = stage.state;
    const element = selection && elementOf(current, selection);
    if (selection === null || element === null) return null;
    const point = selection.vertex && lineOf(element, selection.vertex.side)?.[selection.vertex.index];
    const vertex = selection.vertex && { kind: selection.kind, id: selection.id, ...selection.vertex };
    return { key: { kind: selection.kind, id: selection.id }, vertex, point: point ?? null };
  };

  const nothing = (): Outcome => stage.refuse("Select an element first.");

  return {
    moveVertex,
    moveElement,
    nudge: (by) => {
      const selected = selectedVertex();
      if (selected === null) return nothing();
      const { key, vertex, point } = selected;
      if (vertex === null || point === null) return moveElement(key, by);
      return moveVertex(vertex, { x: point.x + by.x, y: point.y + by.y });
    },
    stageVertex: (vertex, to) => stage.preview((document) => planVertexMove(document, vertex, to)),
    stageElement: (key, by) => stage.preview((document) => planElementMove(document, key, by)),
    stageNewVertex: (after, at) => stage.preview((document) => planVertexInsertion(document, after, at)),
    commitStaged: () => {
      const { staged } = stage.state;
      if (staged === null) return { ok: true };
      return stage.run(() => ({ note: staged.note, changes: staged.changes }));
    },
    cancelStaged: () => store.setState({ staged: null }),
    addVertex: (vertex, at) => stage.run((document) => planVertexInsertion(document, vertex, at)),
    removeVertex: (vertex) => stage.run((document) => planVertexRemoval(document, vertex)),
    removeSelected: () => {
      const selected = selectedVertex();
      if (selected === null) return nothing();
      const { key, vertex } = selected;
      return stage.run((document) =>
        vertex === null ? planDeletion(document, key) : planVertexRemoval(document, vertex),
      );
    },
    setMark: (lane, side, mark) => {
      const done = stage.run((document) => planMark(document, lane, side, mark));
      const painted = stage.state.current.lanes.get(lane);
      const others = done.ok && painted ? paintedOtherwise(stage.state.current, painted, side) : [];
      if (others.length > 0) stage.say(besidePainted(others));
      return done;
    },
    setLaneType: (lane, laneType) => stage.run((document) => planLaneType(document, lane, laneType)),
    setIntersection: (lane, flag) => stage.run((document) => planIntersection(document, lane, flag)),
    insertLaneBeside: (lane, side, width) =>
      insert("lane_segment", (document, id) => planLaneBeside(document, lane, side, id, width)),
    drawLane,
    insertCrossing,
    cutLane: async (lane, at, reach) => {
      const { base } = stage.state;
      const done = await insert(
        "lane_segment",
        (document, id, others) => planCut(base, document, lane, at, reach, [id, ...others]),
        idsForCut(base, lane),
      );
      if (done.ok) stage.say(CUT);
      return done;
    },
    joinLane: (lane) => {
      const done = stage.run((document) => planJoin(stage.state.base, document, lane));
      const note = stage.state.history.done.at(-1)?.note;
      if (done.ok && note !== undefined) stage.say(`${note}.`);
      return done;
    },
    unlink: (from, to) => stage.run((document) => planUnlink(document, from, to)),
    reverseLane: (lane) => stage.run((document) => planReversal(stage.state.base, document, lane)),
    sketchPoint: (at) => {
      const points = stage.state.sketch?.points ?? [];
      const last = points.at(-1);
      if (last !== undefined && distance(last, at) < 0.01) return;
      store.setState({ sketch: { points: [...points, { x: at.x, y: at.y }] } });
      if (stage.state.tool === "draw_crossing" && points.length === 1) void finishSketch();
    },
    sketchBack: () => {
      const points = stage.state.sketch?.points.slice(0, -1) ?? [];
      store.setState({ sketch: points.length === 0 ? null : { points } });
    },
    finishSketch,
    deleteElement: (key) => stage.run((document) => planDeletion(document, key)),
    revertElement: (key) => stage.run((document) => planRevert(stage.state.base, document, key)),
  };
}

/** City frame to WGS84 for display, and the cursor's way back. Never used to read geometry back from the map. */
import proj4 from "proj4";
import type { Place } from "../editor";
import type { CityFrame } from "./properties";

export type LngLat = [longitude: number, latitude: number];

export interface Projection {
  toLngLat(place: Place): LngLat;
  toCity(longitude: number, latitude: number): Place;
}

/** EPSG 326zz / 327zz: WGS84 UTM zones, north and south. */
export function projectionOf(frame: CityFrame): Projection {
  const zone = frame.epsg % 100;
  const hemisphere = Math.floor(frame.epsg / 100) === 327 ? " +south" : "";
  const utm = proj4(`+proj=utm +zone=${zone}${hemisphere} +datum=WGS84 +units=m +no_defs`);
  const known = new WeakMap<Place, LngLat>();
  return {
    toLngLat(place) {
      const remembered = known.get(place);
      if (remembered !== undefined) return remembered;
      const [longitude, latitude] = utm.inverse([place.x + frame.origin_east, place.y + frame.origin_north]);
      const lngLat: LngLat = [longitude, latitude];
      known.set(place, lngLat);
      return lngLat;
    },
    toCity(longitude, latitude) {
      const [east, north] = utm.forward([longitude, latitude]);
      return { x: east - frame.origin_east, y: north - frame.origin_north };
    },
  };
}

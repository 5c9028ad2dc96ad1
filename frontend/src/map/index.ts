/** The map: the only importer of maplibre-gl. */
export { MapView } from "./MapView";
export { CHANGE_COLOURS } from "./palette";
export type {
  CityFrame,
  Direction,
  DriveFrame,
  DrivePath,
  LidarImage,
  MapHandle,
  MapMarker,
  MapViewMode,
  MapViewProperties,
  PageCommand,
} from "./properties";

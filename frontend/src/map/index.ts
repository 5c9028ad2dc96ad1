/** The map: the only importer of maplibre-gl. */
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

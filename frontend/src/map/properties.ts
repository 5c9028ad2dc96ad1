/** The contract between the workspace page and the map. */
import type { Editor, ElementKey, KeyCommand, KeyText } from "../editor";

/** City frame = UTM zone `epsg` minus the origin. */
export interface CityFrame {
  readonly city: string;
  readonly epsg: number;
  readonly origin_east: number;
  readonly origin_north: number;
}

/** Intensity image, north up; `bounds` = min x, min y, max x, max y in city metres. */
export interface LidarImage {
  readonly url: string;
  readonly bounds: readonly number[];
}

export interface DriveFrame {
  readonly index: number;
  readonly x: number;
  readonly y: number;
  readonly heading_rad: number;
}

export interface DrivePath {
  readonly trajectory: readonly (readonly number[])[];
  readonly frames: readonly DriveFrame[];
}

/** Which state of the world is shown; `difference` colours what changed. */
export type MapViewMode = "prior" | "current" | "difference";
export type Direction = "prior_to_current" | "current_to_prior";

/** Commands that keys give with the map focused and that the page carries out, not the map. */
export type PageCommand =
  | {
      readonly name:
        | "save"
        | "help"
        | "find"
        | "next_issue"
        | "apply_fix"
        | "canonical"
        | "next_frame"
        | "previous_frame";
    }
  | { readonly name: "flicker"; readonly held: boolean };

export interface MapMarker {
  readonly key: ElementKey;
  /** `none` is not marked. */
  readonly severity: "error" | "warning" | "none";
}

export interface MapViewProperties {
  readonly editor: Editor;
  readonly frame: CityFrame;
  /** min x, min y, max x, max y of the log, city metres. */
  readonly bounds: readonly number[];
  readonly drivableAreas: readonly (readonly (readonly number[])[])[];
  readonly direction: Direction;
  readonly view: MapViewMode;
  readonly lidar?: LidarImage | null;
  /** 0 to 1. */
  readonly lidarOpacity?: number;
  /** Direction arrows; default: shown. */
  readonly arrows?: boolean;
  readonly drive?: DrivePath | null;
  readonly activeFrame?: number | null;
  readonly onFrame?: (index: number) => void;
  /** The check's categories by element; without it the editor's quick classification colours the map. */
  readonly categories?: ReadonlyMap<KeyText, readonly string[]> | null;
  readonly violations?: readonly MapMarker[];
  readonly theme?: "dark" | "light";
  readonly onCommand?: (command: PageCommand) => void;
  /** The map cannot be shown; the reason and what to do, in words. */
  readonly onUnavailable?: (reason: string) => void;
}

/** What the page may ask of the mounted map (`ref`). */
export type LaneCommand = Extract<KeyCommand, "join" | "reverse">;

export interface MapHandle {
  fitLog(): void;
  fitElement(key: ElementKey): void;
  /** What the keys for it do to the selected lane, wherever the focus is. */
  editLane(command: LaneCommand): void;
  focus(): void;
}

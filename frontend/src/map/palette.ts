/** Colours of the map: calm greys for the world, the five change colours for changes alone. */

export const CHANGE_COLOURS = {
  insertion: "#8dea7b",
  deletion: "#ff5a5f",
  geometry: "#1f8f4d",
  marking: "#a46bff",
  type: "#ffd23f",
} as const;

export type ChangeColour = keyof typeof CHANGE_COLOURS;
export const CHANGE_NAMES = Object.keys(CHANGE_COLOURS) as readonly ChangeColour[];

export interface Palette {
  readonly canvas: string;
  readonly drivable: string;
  readonly vehicle: string;
  readonly bike: string;
  readonly bus: string;
  readonly intersection: string;
  readonly implied: string;
  readonly white: string;
  readonly yellow: string;
  readonly blue: string;
  readonly crossing: string;
  readonly trajectory: string;
  readonly arrow: string;
}

export const PALETTES: Readonly<Record<"dark" | "light", Palette>> = {
  dark: {
    canvas: "#0f1318",
    drivable: "#151b22",
    vehicle: "#262d37",
    bike: "#21303a",
    bus: "#302d3a",
    intersection: "#1f262f",
    implied: "#566273",
    white: "#e9edf2",
    yellow: "#f5b93a",
    blue: "#5aa2ff",
    crossing: "#c9ced6",
    trajectory: "#ff9f45",
    arrow: "#8e99a8",
  },
  light: {
    canvas: "#eef1f5",
    drivable: "#e3e8ee",
    vehicle: "#c9d0d9",
    bike: "#bfd3d6",
    bus: "#d3cbd9",
    intersection: "#d3d9e1",
    implied: "#8a95a3",
    white: "#ffffff",
    yellow: "#d98a00",
    blue: "#2f6fdc",
    crossing: "#ffffff",
    trajectory: "#c96a12",
    arrow: "#5c6775",
  },
};

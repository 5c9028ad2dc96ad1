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
    canvas: "#eef1f4",
    drivable: "#dfe5ec",
    vehicle: "#8a96a5",
    bike: "#7a979d",
    bus: "#948aa3",
    intersection: "#98a3b0",
    implied: "#5f6b79",
    white: "#ffffff",
    yellow: "#ffd04d",
    blue: "#1f5fd0",
    crossing: "#ffffff",
    trajectory: "#c25a00",
    arrow: "#3a4552",
  },
};

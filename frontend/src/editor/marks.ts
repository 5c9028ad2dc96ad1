/** The 15 legal AV2 marks, factored into pattern and colour, and how each is painted. */
import type { Mark } from "./elements";

export const MARKS: readonly Mark[] = [
  "SOLID_WHITE",
  "DASHED_WHITE",
  "DOUBLE_SOLID_WHITE",
  "DOUBLE_DASH_WHITE",
  "SOLID_DASH_WHITE",
  "DASH_SOLID_WHITE",
  "SOLID_YELLOW",
  "DASHED_YELLOW",
  "DOUBLE_SOLID_YELLOW",
  "DOUBLE_DASH_YELLOW",
  "SOLID_DASH_YELLOW",
  "DASH_SOLID_YELLOW",
  "SOLID_BLUE",
  "NONE",
  "UNKNOWN",
];

export type MarkColour = "white" | "yellow" | "blue" | "none";

/** One painted stripe. `place`: -1 nearer to the lane that carries the mark, 0 on the line, 1 on the far side. */
export interface Stripe {
  readonly dashed: boolean;
  readonly place: -1 | 0 | 1;
}

const STRIPES: Readonly<Record<string, readonly Stripe[]>> = {
  SOLID: [{ dashed: false, place: 0 }],
  DASHED: [{ dashed: true, place: 0 }],
  DOUBLE_SOLID: [
    { dashed: false, place: -1 },
    { dashed: false, place: 1 },
  ],
  DOUBLE_DASH: [
    { dashed: true, place: -1 },
    { dashed: true, place: 1 },
  ],
  SOLID_DASH: [
    { dashed: false, place: -1 },
    { dashed: true, place: 1 },
  ],
  DASH_SOLID: [
    { dashed: true, place: -1 },
    { dashed: false, place: 1 },
  ],
};

/** The paint's stripes; none for NONE and UNKNOWN. */
export function stripesOf(mark: Mark): readonly Stripe[] {
  return STRIPES[patternOf(mark)] ?? [];
}

/** Mark type without its colour, e.g. DOUBLE_SOLID; NONE and UNKNOWN are their own. */
export function patternOf(mark: Mark): string {
  return colourOf(mark) === "none" ? mark : mark.slice(0, mark.lastIndexOf("_"));
}

export function colourOf(mark: Mark): MarkColour {
  if (mark.endsWith("_WHITE")) return "white";
  if (mark.endsWith("_YELLOW")) return "yellow";
  return mark === "SOLID_BLUE" ? "blue" : "none";
}

const MIRRORED: Partial<Record<Mark, Mark>> = {
  DASH_SOLID_WHITE: "SOLID_DASH_WHITE",
  SOLID_DASH_WHITE: "DASH_SOLID_WHITE",
  DASH_SOLID_YELLOW: "SOLID_DASH_YELLOW",
  SOLID_DASH_YELLOW: "DASH_SOLID_YELLOW",
};

/** The same paint read from the lane on its other side: mixed marks exchange their words. */
export function mirrored(mark: Mark): Mark {
  return MIRRORED[mark] ?? mark;
}

/** The mark as a person says it: "double solid yellow". */
export function markWords(mark: Mark): string {
  if (mark === "NONE") return "no paint";
  if (mark === "UNKNOWN") return "unknown paint";
  const words: Readonly<Record<string, string>> = {
    SOLID: "solid",
    DASHED: "dashed",
    DOUBLE_SOLID: "double solid",
    DOUBLE_DASH: "double dashed",
    SOLID_DASH: "solid and dashed",
    DASH_SOLID: "dashed and solid",
  };
  return `${words[patternOf(mark)] ?? "solid"} ${colourOf(mark)}`;
}

/** How each mark is painted: its stripes from the lane outwards, and their colour. */
import type { Mark } from "../../api/types";

export type Stripe = "solid" | "dashed";
export type PaintColour = "white" | "yellow" | "blue" | "unknown";

export interface Paint {
  /** None: nothing is painted. In mixed marks the first is nearer to the lane. */
  stripes: readonly Stripe[];
  colour: PaintColour;
}

export const PAINT: Record<Mark, Paint> = {
  NONE: { stripes: [], colour: "white" },
  DASHED_WHITE: { stripes: ["dashed"], colour: "white" },
  DASHED_YELLOW: { stripes: ["dashed"], colour: "yellow" },
  SOLID_WHITE: { stripes: ["solid"], colour: "white" },
  SOLID_YELLOW: { stripes: ["solid"], colour: "yellow" },
  DOUBLE_SOLID_WHITE: { stripes: ["solid", "solid"], colour: "white" },
  DOUBLE_SOLID_YELLOW: { stripes: ["solid", "solid"], colour: "yellow" },
  DOUBLE_DASH_WHITE: { stripes: ["dashed", "dashed"], colour: "white" },
  DOUBLE_DASH_YELLOW: { stripes: ["dashed", "dashed"], colour: "yellow" },
  SOLID_DASH_WHITE: { stripes: ["solid", "dashed"], colour: "white" },
  SOLID_DASH_YELLOW: { stripes: ["solid", "dashed"], colour: "yellow" },
  DASH_SOLID_WHITE: { stripes: ["dashed", "solid"], colour: "white" },
  DASH_SOLID_YELLOW: { stripes: ["dashed", "solid"], colour: "yellow" },
  SOLID_BLUE: { stripes: ["solid"], colour: "blue" },
  UNKNOWN: { stripes: ["dashed"], colour: "unknown" },
};

/** The 15 legal marks in the order of the pickers. */
export const MARKS = Object.keys(PAINT) as Mark[];

import {
  IconArrowsDiff,
  IconLineDashed,
  IconMinus,
  IconPlus,
  IconRouteAltLeft,
  IconSwitchHorizontal,
} from "@tabler/icons-react";
import type { ComponentType } from "react";
import type { Category } from "../../api/types";
import classes from "./parts.module.css";
import { CATEGORY_WORDS } from "./words";

interface IconProperties {
  size: number;
  stroke: number;
  "aria-hidden": true;
}

const ICONS: Record<Category, ComponentType<IconProperties>> = {
  insertion: IconPlus,
  deletion: IconMinus,
  geometry: IconArrowsDiff,
  marking: IconLineDashed,
  type: IconSwitchHorizontal,
  connectivity: IconRouteAltLeft,
};

const LIGHT_INK: ReadonlySet<Category> = new Set(["geometry", "connectivity"]);

/** Stripes of all the colours of an element that changed in several ways. */
function fill(categories: readonly Category[]): string {
  const colours = categories.map((category) => `var(--change-${category})`);
  if (colours.length <= 1) return colours[0] ?? "var(--change-connectivity)";
  const width = 5;
  const stops = colours.map((colour, i) => `${colour} ${i * width}px ${(i + 1) * width}px`);
  return `repeating-linear-gradient(135deg, ${stops.join(", ")})`;
}

/** The colour of a change with its icon and, for screen readers, its word. */
export function CategoryMark({ categories }: { categories: readonly Category[] }) {
  const first = categories[0] ?? "connectivity";
  const Icon = ICONS[first];
  const ink = LIGHT_INK.has(first) ? "#fff" : "#0f1318";
  return (
    <span className={classes.swatch} style={{ background: fill(categories), color: ink }}>
      {categories.length <= 1 && <Icon size={12} stroke={2.5} aria-hidden />}
      <span className="visually-hidden">{categories.map((name) => CATEGORY_WORDS[name]).join(", ")}</span>
    </span>
  );
}

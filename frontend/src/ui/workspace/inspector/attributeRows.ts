/** The changed attributes of an element in words, old → new; lines and links are told by the change's detail. */
import type { Attributes, Change } from "../../../api/types";
import { MARKS, type Mark, markWords } from "../../../editor";
import { LANE_TYPE_WORDS } from "../../parts/words";

const NAMES: Readonly<Record<string, string>> = {
  lane_type: "type",
  left_lane_mark_type: "left mark",
  right_lane_mark_type: "right mark",
  is_intersection: "in an intersection",
};

function words(value: unknown): string {
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (typeof value !== "string") return "—";
  if ((MARKS as readonly string[]).includes(value)) return markWords(value as Mark);
  return (LANE_TYPE_WORDS as Readonly<Record<string, string>>)[value]?.toLowerCase() ?? value;
}

export interface AttributeRow {
  name: string;
  before: string;
  after: string;
}

export function attributeRows(change: Pick<Change, "old" | "new">): AttributeRow[] {
  const before: Attributes | null = change.old;
  const after: Attributes | null = change.new;
  if (before === null || after === null) return [];
  return Object.entries(NAMES)
    .filter(([key]) => key in after && before[key] !== after[key])
    .map(([key, name]) => ({ name, before: words(before[key]), after: words(after[key]) }));
}

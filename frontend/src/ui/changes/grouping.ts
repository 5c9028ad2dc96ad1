/** Findings as lists show them: changes by the structural update that they belong to. */
import type { Change, ElementKey, Findings, Macros, StructuralUpdate } from "../../api/types";

export interface ChangeGroup {
  key: string;
  title: string;
  /** All elements of the update. */
  elements: readonly ElementKey[];
  /** The macro-modifications that follow; null: in no update. */
  macros: Macros | null;
  changes: readonly Change[];
}

const keyOf = (element: ElementKey) => `${element.kind}:${element.id}`;

/** "shape", "lane graph", "lane number −1". */
export function macroWords(macros: Macros): string[] {
  const words: string[] = [];
  if (macros.shape) words.push("shape");
  if (macros.appearance) words.push("appearance");
  if (macros.function) words.push("function");
  if (macros.lane_graph) words.push("lane graph");
  if (macros.lane_number !== 0) {
    words.push(`lane number ${macros.lane_number > 0 ? "+" : "−"}${Math.abs(macros.lane_number)}`);
  }
  return words;
}

/** The update's title without its macros, which have a line of their own. */
const headline = ({ title }: StructuralUpdate) => title.split(": ")[0] ?? title;

/** Every change once: under its update, and last those that no update holds. */
export function groupChanges(findings: Findings): ChangeGroup[] {
  const rest = new Map(findings.changes.map((change) => [keyOf(change), change]));
  const groups: ChangeGroup[] = [];
  for (const update of findings.updates) {
    const changes: Change[] = [];
    for (const [kind, id] of update.elements) {
      const key = keyOf({ kind, id });
      const change = rest.get(key);
      if (change === undefined) continue;
      changes.push(change);
      rest.delete(key);
    }
    const first = changes[0];
    if (first === undefined) continue;
    const elements = update.elements.map(([kind, id]) => ({ kind, id }));
    groups.push({ key: keyOf(first), title: headline(update), elements, macros: update.macros, changes });
  }
  if (rest.size > 0)
    groups.push({ key: "rest", title: "Elsewhere", elements: [], macros: null, changes: [...rest.values()] });
  return groups;
}

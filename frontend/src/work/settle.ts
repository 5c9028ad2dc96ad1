/** Settling a stale save: my edits again, but against the newer revision and with each conflict decided. */
import type { Attributes, ConflictingElement } from "../api/types";
import type { Edit } from "../editor";

export type Side = "mine" | "theirs";

export const conflictKey = (element: { kind: string; id: number }) => `${element.kind}:${element.id}`;

/**
 * Edits for the newer revision: those of elements without a conflict as they are (nobody else touched them), and for
 * each conflict either nothing (theirs stays) or the edit that turns theirs into mine.
 */
export function settledEdits(
  edits: readonly Edit[],
  conflicts: readonly ConflictingElement[],
  choices: ReadonlyMap<string, Side>,
): Edit[] {
  const contested = new Map(conflicts.map((conflict) => [conflictKey(conflict), conflict]));
  const settled: Edit[] = [];
  for (const edit of edits) {
    const conflict = contested.get(conflictKey(edit));
    if (conflict === undefined) settled.push(edit);
    else if (choices.get(conflictKey(edit)) === "mine") {
      const again = editFromTheirs(conflict);
      if (again !== null) settled.push(again);
    }
  }
  return settled;
}

function editFromTheirs({ kind, id, mine, theirs }: ConflictingElement): Edit | null {
  if (mine === null) return theirs === null ? null : { operation: "delete", kind, id, attributes: {} };
  const wanted = Object.fromEntries(Object.entries(mine).filter(([name]) => name !== "id"));
  if (theirs === null) return { operation: "insert", kind, id, attributes: wanted };
  const attributes: Attributes = {};
  for (const [name, value] of Object.entries(wanted)) {
    if (JSON.stringify(value) !== JSON.stringify(theirs[name])) attributes[name] = value;
  }
  return Object.keys(attributes).length === 0 ? null : { operation: "update", kind, id, attributes };
}

/** Names of the attributes in which two versions of an element differ. */
export function differingNames(a: Attributes | null, b: Attributes | null): string[] {
  const names = new Set([...Object.keys(a ?? {}), ...Object.keys(b ?? {})]);
  return [...names].filter((name) => JSON.stringify(a?.[name]) !== JSON.stringify(b?.[name]));
}

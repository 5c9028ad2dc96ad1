/** Settling a stale save: my edits again, but against the newer revision and with each conflict decided. */
import type { Attributes, ConflictingElement } from "../api/types";
import type { Edit } from "../editor";

export type Side = "mine" | "theirs";

export const conflictKey = (element: { kind: string; id: number }) => `${element.kind}:${element.id}`;

/**
 * Edits for the newer revision: those of elements without a conflict as they are (nobody else touched them), and for
 * each conflict either nothing (theirs stays) or the edit that turns theirs into mine. The parts of a cut lane that
 * stays theirs are left out, for they would lie on it; links to them lead to the lane again.
 */
export function settledEdits(
  edits: readonly Edit[],
  conflicts: readonly ConflictingElement[],
  choices: ReadonlyMap<string, Side>,
): Edit[] {
  const contested = new Map(conflicts.map((conflict) => [conflictKey(conflict), conflict]));
  const parts = partsGivenUp(edits, conflicts, choices);
  const settled: Edit[] = [];
  for (const edit of edits) {
    if (edit.kind === "lane_segment" && parts.has(edit.id)) continue;
    const conflict = contested.get(conflictKey(edit));
    if (conflict === undefined) settled.push(edit);
    else if (choices.get(conflictKey(edit)) === "mine") {
      const again = editFromTheirs(conflict);
      if (again !== null) settled.push(again);
    }
  }
  return parts.size === 0 ? settled : settled.map((edit) => linkedToWholes(edit, parts));
}

/** Whether the edits cut this lane into parts. */
export const isCut = (edits: readonly Edit[], { kind, id }: Pick<ConflictingElement, "kind" | "id">) =>
  kind === "lane_segment" &&
  edits.some((edit) => edit.operation === "insert" && edit.attributes.part_of === id);

/** The new parts of lanes that stay as others made them, each with its lane; null: they deleted it. */
function partsGivenUp(
  edits: readonly Edit[],
  conflicts: readonly ConflictingElement[],
  choices: ReadonlyMap<string, Side>,
): Map<number, number | null> {
  const given = new Map<number, number | null>();
  for (const conflict of conflicts) {
    const { kind, id, theirs } = conflict;
    if (kind !== "lane_segment" || choices.get(conflictKey(conflict)) !== "theirs") continue;
    for (const edit of edits) {
      if (edit.operation === "insert" && edit.attributes.part_of === id) given.set(edit.id, theirs && id);
    }
  }
  return given;
}

function linkedToWholes(edit: Edit, wholes: ReadonlyMap<number, number | null>): Edit {
  const whole = (id: number | null) => (id === null ? null : wholes.has(id) ? (wholes.get(id) ?? null) : id);
  const attributes = { ...edit.attributes };
  for (const name of ["successors", "predecessors"] as const) {
    const ids = attributes[name];
    if (ids) attributes[name] = [...new Set(ids.map(whole).filter((id) => id !== null))];
  }
  for (const name of ["left_neighbor_id", "right_neighbor_id"] as const) {
    const id = attributes[name];
    if (id !== undefined) attributes[name] = whole(id);
  }
  return { ...edit, attributes };
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

/** What the workspace knows of its work: how much is unsaved, where it is kept, and what the server says of it. */
import type { Problem } from "../api/problem";
import type { ConflictingElement, Draft, Findings } from "../api/types";
import { type Declaration, type Edit, sameDeclarations } from "../editor";

/** Where the unsaved work is kept. */
export type Keeping =
  /** Nothing is unsaved. */
  | { where: "nothing" }
  /** On this computer; on its way to the server. */
  | { where: "computer" }
  /** On this computer only: the server cannot be reached; asked again by itself. */
  | { where: "offline" }
  /** On this computer only: the server refuses it. */
  | { where: "refused"; problem: Problem }
  | { where: "server"; at: number }
  /** Not even this computer keeps it (private browsing, full disk). */
  | { where: "nowhere"; problem: Problem };

export type Saving = "no" | "sending" | "waiting";

export interface StaleBase {
  head: number;
  conflicts: ConflictingElement[];
  /** All that is declared there. */
  declarations: Declaration[];
}

export interface WorkState {
  /** What was changed since the open revision, as `countChanges` counts. */
  edits: number;
  revision: number;
  keeping: Keeping;
  saving: Saving;
  /** null: not checked yet. */
  findings: Findings | null;
  checking: boolean;
  /** The last check that failed for another reason than the connection. */
  checkProblem: Problem | null;
  /** Others saved a newer revision that contradicts the draft. */
  stale: StaleBase | null;
  /** Another window or computer kept a newer draft. */
  newerDraft: Draft | null;
  /** Another tab of this browser took the task over; this one does not edit any more. */
  elsewhere: boolean;
}

const FOLLOWS = new Set(["successors", "predecessors", "left_neighbor_id", "right_neighbor_id"]);

/** What of an edit is counted, whoever kept it. */
type CountedEdit = Pick<Edit, "operation" | "kind" | "id"> & { readonly attributes?: object };

/** The lane that an edit makes a part of. */
const wholeOf = ({ operation, attributes = {} }: CountedEdit) =>
  operation === "insert" && "part_of" in attributes && typeof attributes.part_of === "number"
    ? attributes.part_of
    : null;

/**
 * How many elements an annotator would say were edited: those whose links alone follow another's edit do not count, and
 * a lane that is cut counts once.
 */
export function countEdits(edits: readonly CountedEdit[]): number {
  const cut = new Set(edits.map(wholeOf).filter((whole) => whole !== null));
  const others = edits.filter((edit) => {
    if (edit.operation === "update")
      return Object.keys(edit.attributes ?? {}).some((name) => !FOLLOWS.has(name));
    return wholeOf(edit) === null && !(edit.kind === "lane_segment" && cut.has(edit.id));
  });
  return others.length + cut.size || edits.length;
}

interface CountedDraft {
  readonly edits: readonly CountedEdit[];
  readonly declarations?: readonly Declaration[] | null;
}

/** The same with what is declared otherwise than in the saved revision (`standing`), which counts as one. */
export function countChanges(
  { edits, declarations }: CountedDraft,
  standing?: readonly Declaration[],
): number {
  const untouched = declarations == null || (standing && sameDeclarations(declarations, standing));
  return countEdits(edits) + (untouched ? 0 : 1);
}

export const blockingErrors = (findings: Findings | null): number =>
  findings?.violations.filter((violation) => violation.blocks).length ?? 0;

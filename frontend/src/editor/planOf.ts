/** The plan of what was done to a workpiece, unless an element came out unusable. */
import { hasRepeatedVertex, lineNames, lineOf } from "./lines";
import { type Planned, refuse } from "./plan";
import type { Selection } from "./state";
import type { Workpiece } from "./workpiece";

const REPEATED = "Two vertices of one line would lie on each other. Remove one of them instead.";

/** `select`: what is selected afterwards; left out: what was. */
export function planOf(work: Workpiece, note: string, select?: Selection | null): Planned {
  const changes = work.changes();
  for (const { before, after } of changes) {
    if (after === null) continue;
    for (const name of lineNames(after.kind)) {
      const line = lineOf(after, name);
      const was = before && lineOf(before, name);
      if (line !== null && line !== was && hasRepeatedVertex(line)) return refuse(REPEATED);
    }
  }
  return select === undefined ? { note, changes } : { note, changes, select };
}

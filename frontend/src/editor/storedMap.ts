/** A stored revision as a map. */
import { applyChanges, differingKeys, elementOf, emptyDocument, type MapDocument } from "./document";
import { equalElements } from "./equality";
import { readMap } from "./read";
import type { EditorSavedRevision, EditorWorkspace } from "./wire";

/** A stored revision from the map that it differs from; equal elements stay the same objects. */
export function storedMap(
  before: MapDocument,
  stored: Pick<EditorWorkspace | EditorSavedRevision, "changed" | "removed">,
): MapDocument {
  const changed = readMap(stored.changed);
  const changes = [
    ...stored.removed.map((key) => ({ key, before: null, after: null })),
    ...differingKeys(emptyDocument, changed)
      .map((key) => ({ key, before: elementOf(before, key), after: elementOf(changed, key) }))
      .filter((change) => !equalElements(change.before, change.after)),
  ];
  return applyChanges(before, changes);
}

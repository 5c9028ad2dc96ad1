import { elementOf, equalElements, keyText, type MapElement } from "../../../editor";
import { useNow } from "../../parts/useNow";
import { ago } from "../../parts/words";
import { useEditor, useScreen } from "../context";
import classes from "./inspector.module.css";

/** Who wrote the element last, and in which revision. */
export function Attribution({ element, deleted }: { element: MapElement; deleted: boolean }) {
  const version = useScreen((state) => state.versions.get(keyText(element)));
  const revision = useScreen((state) => state.revisions.find(({ number }) => number === version));
  const unsaved = useEditor((state) => {
    const stored = elementOf(state.saved, element);
    return deleted ? stored !== null : !equalElements(stored, element);
  });
  const now = useNow();
  let words = "imported, unchanged since";
  if (unsaved) words = "changed in this draft, not saved yet";
  else if (revision !== undefined) {
    words = `revision ${revision.number} · ${revision.author?.name ?? "import"} · ${ago(revision.created_at, now)}`;
  }
  return (
    <section className={classes.section}>
      <h3 className="label">Version</h3>
      <p className="second">{words}</p>
    </section>
  );
}

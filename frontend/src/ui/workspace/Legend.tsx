import { CategoryMark } from "../parts/CategoryMark";
import { CATEGORY_WORDS, COUNTED_CATEGORIES } from "../parts/words";
import { useScreen } from "./context";
import classes from "./workspace.module.css";

/** What the colours of changes mean. */
export function Legend() {
  const view = useScreen((state) => state.view);
  if (view !== "difference") return null;
  return (
    <section className={classes.legend} aria-label="Colours of changes">
      {COUNTED_CATEGORIES.map((category) => (
        <span key={category} className={classes.legendItem}>
          <span aria-hidden="true">
            <CategoryMark categories={[category]} />
          </span>
          {CATEGORY_WORDS[category]}
        </span>
      ))}
    </section>
  );
}

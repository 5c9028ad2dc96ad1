import type { Macros } from "../../api/types";
import classes from "./changes.module.css";
import { macroWords } from "./grouping";

/** How the local road changed by an update, each macro a chip. */
export function MacroChips({ macros }: { macros: Macros }) {
  return (
    <ul className={classes.chips} aria-label="Macros">
      {macroWords(macros).map((word) => (
        <li key={word} className={classes.chip}>
          {word}
        </li>
      ))}
    </ul>
  );
}

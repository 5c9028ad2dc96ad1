import type { Category, Task } from "../../api/types";
import classes from "./parts.module.css";
import { CATEGORY_WORDS, COUNTED_CATEGORIES, counted } from "./words";

/** "2 insertion, 1 marking": what a change bar shows, in words. */
export function changeCounts(changes: Partial<Record<Category, number>>): string {
  const parts = COUNTED_CATEGORIES.filter((name) => (changes[name] ?? 0) > 0).map(
    (name) => `${changes[name] ?? 0} ${CATEGORY_WORDS[name]}`,
  );
  return parts.length === 0 ? "no change" : parts.join(", ");
}

/** How many elements of a task changed, and how the changes divide over the categories. */
export function ChangeBar({ task }: { task: Pick<Task, "changes" | "changed_elements"> }) {
  const words = `${counted(task.changed_elements, "changed element")}: ${changeCounts(task.changes)}`;
  return (
    <span className={classes.changes} role="img" aria-label={words} title={words}>
      <span className={classes.count}>{task.changed_elements}</span>
      <span className={classes.bar}>
        {COUNTED_CATEGORIES.map((name) => (
          <span
            key={name}
            style={{ flexGrow: task.changes[name] ?? 0, background: `var(--change-${name})` }}
          />
        ))}
      </span>
    </span>
  );
}

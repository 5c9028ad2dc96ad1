import type { TaskState } from "../../api/types";
import { STATE_WORDS } from "../parts/words";
import classes from "./pages.module.css";
import type { Filter } from "./useFilter";

const STATES = Object.keys(STATE_WORDS) as TaskState[];

export const asStates = (values: readonly string[]): TaskState[] =>
  STATES.filter((state) => values.includes(state));

/** The states with how many tasks each has; a click keeps or drops one. */
export function StateFilter({
  filter,
  counts,
}: {
  filter: Filter;
  counts: Partial<Record<TaskState, number>>;
}) {
  const chosen = asStates(filter.values("state"));
  const toggle = (state: TaskState) =>
    filter.set({
      state: chosen.includes(state) ? chosen.filter((one) => one !== state) : [...chosen, state],
    });
  return (
    <fieldset className={classes.states} aria-label="States">
      {STATES.map((state) => (
        <button
          key={state}
          type="button"
          className={classes.state}
          aria-pressed={chosen.includes(state)}
          onClick={() => toggle(state)}
        >
          {STATE_WORDS[state]} {counts[state] ?? 0}
        </button>
      ))}
    </fieldset>
  );
}

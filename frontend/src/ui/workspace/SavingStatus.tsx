import { savingWords } from "../../work/savingWords";
import { blockingErrors } from "../../work/workState";
import { useNow } from "../parts/useNow";
import { counted } from "../parts/words";
import { useWorkspace } from "./context";
import type { Commands } from "./useCommands";
import { useWork } from "./useFindings";
import classes from "./workspace.module.css";

/** Where the work is, in words, and what stops the save. */
export function SavingStatus({ commands }: { commands: Commands }) {
  const { screen } = useWorkspace();
  const now = useNow(1_000);
  const state = useWork((work) => work);
  const { text, tone } = savingWords(state, now);
  const errors = blockingErrors(state.findings);
  const stale = state.stale;
  return (
    <>
      <span className={classes.saving} data-tone={tone} role="status" title={text}>
        <span className={classes.dot} aria-hidden="true" />
        <span className={classes.savingText}>{text}</span>
      </span>
      {errors > 0 && (
        <button type="button" className={classes.stop} onClick={() => commands.show("issues")}>
          {counted(errors, "error")} {errors === 1 ? "stops" : "stop"} the save
        </button>
      )}
      {stale !== null && (
        <button type="button" className={classes.stop} onClick={() => screen.setState({ staleShown: true })}>
          revision {stale.head} contradicts {counted(stale.conflicts.length, "edit")}
        </button>
      )}
    </>
  );
}

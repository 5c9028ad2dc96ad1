import { Button } from "@mantine/core";
import type { Choosing } from "../../work/openTask";
import { countChanges } from "../../work/workState";
import { useNow } from "../parts/useNow";
import { ago, counted } from "../parts/words";
import classes from "./workspace.module.css";

interface ChooseDraftProperties {
  choosing: Choosing;
  onChoose: (decision: "local" | "server") => void;
}

/** Two drafts of the same task hold different work; the other one is set aside, not thrown away. */
export function ChooseDraft({ choosing, onChoose }: ChooseDraftProperties) {
  const now = useNow();
  const { local, server, workspace } = choosing;
  return (
    <main className="centred">
      <h1>Two drafts of task {workspace.task.id}</h1>
      <p className="second">
        You edited this task in two places. Choose the draft to go on with; the other is set aside under
        History and can be downloaded there.
      </p>
      <button type="button" className={classes.choice} onClick={() => onChoose("local")}>
        <strong>This computer's</strong>
        <span className="second">
          {counted(countChanges(local, workspace.declarations), "change")} since revision {local.baseRevision}{" "}
          · {ago(local.changedAt, now)}
        </span>
      </button>
      <button type="button" className={classes.choice} onClick={() => onChoose("server")}>
        <strong>The other window's or computer's</strong>
        <span className="second">
          {counted(countChanges(server, workspace.declarations), "change")} since revision{" "}
          {server.base_revision} · {ago(server.kept_at, now)}
        </span>
      </button>
      <Button variant="default" component="a" href="/">
        Decide later
      </Button>
    </main>
  );
}

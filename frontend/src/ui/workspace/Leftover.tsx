import { Button } from "@mantine/core";
import type { Task } from "../../api/types";
import type { LocalDraft } from "../../work/browserStore";
import { countChanges } from "../../work/workState";
import { counted, STATE_WORDS } from "../parts/words";
import { Banner } from "./Banner";
import { downloadDraft } from "./downloadDraft";

/** Unsaved work that the task does not take in its present state; it stays on this computer. */
export function Leftover({ task, draft }: { task: Task; draft: LocalDraft }) {
  return (
    <Banner tone="warning">
      <span>
        {counted(countChanges(draft), "change")} of yours since revision {draft.baseRevision} cannot be saved
        while the task is {STATE_WORDS[task.state]} or assigned to somebody else. They stay on this computer.
      </span>
      <Button variant="default" onClick={() => downloadDraft(task.id, draft)}>
        Download them
      </Button>
    </Banner>
  );
}

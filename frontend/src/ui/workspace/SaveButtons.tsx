import { Button, Group, Modal, Stack } from "@mantine/core";
import { useState } from "react";
import { takeStep } from "../../api/tasks";
import { blockingErrors } from "../../work/workState";
import { tell, tellProblem } from "../shell/tell";
import { useScreen, useWorkspace } from "./context";
import type { Commands } from "./useCommands";
import { useWork } from "./useFindings";

export function SaveButtons({ commands }: { commands: Commands }) {
  const edits = useWork((state) => state.edits);
  const saving = useWork((state) => state.saving);
  const stopped = useWork((state) => blockingErrors(state.findings) > 0 || state.stale !== null);
  return (
    <>
      <Button
        rightSection={<kbd>Ctrl S</kbd>}
        disabled={edits === 0}
        data-stopped={stopped || undefined}
        title={stopped ? "Something stops the save; this shows what" : undefined}
        loading={saving !== "no"}
        onClick={commands.save}
      >
        Save
      </Button>
      <Submit />
    </>
  );
}

function Submit() {
  const { reopen } = useWorkspace();
  const task = useScreen((state) => state.task);
  const unsaved = useWork((state) => state.edits > 0 || state.saving !== "no");
  const changed = useWork((state) => state.findings === null || state.findings.changes.length > 0);
  const [busy, setBusy] = useState(false);
  const [asking, setAsking] = useState(false);
  if (!task.actions.includes("submit")) return null;

  const submit = () => {
    setAsking(false);
    setBusy(true);
    takeStep(task.id, { action: "submit", revision: task.head })
      .then(() => {
        tell("Submitted. A reviewer takes it from here.");
        reopen();
      }, tellProblem)
      .finally(() => setBusy(false));
  };
  return (
    <>
      <Button
        variant="default"
        disabled={unsaved}
        title={unsaved ? "Save first" : undefined}
        loading={busy}
        onClick={() => (changed ? submit() : setAsking(true))}
      >
        Submit
      </Button>
      <Modal opened={asking} onClose={() => setAsking(false)} title="Submit without a change?">
        <Stack gap={12}>
          <p>This says that prior and current map are the same here.</p>
          <Group justify="flex-end" gap={8}>
            <Button variant="default" onClick={() => setAsking(false)}>
              Cancel
            </Button>
            <Button onClick={submit} data-autofocus>
              Submit as unchanged
            </Button>
          </Group>
        </Stack>
      </Modal>
    </>
  );
}

import { Button, Group, Modal, Stack, Textarea } from "@mantine/core";
import { useState } from "react";
import { takeStep } from "../../api/tasks";
import type { Task } from "../../api/types";
import { ProblemNotice } from "../parts/ProblemNotice";

interface ReopenDialogProperties {
  task: Task;
  onClose: () => void;
  onDone: () => void;
}

export function ReopenDialog({ task, onClose, onDone }: ReopenDialogProperties) {
  const [reason, setReason] = useState("");
  const [busy, setBusy] = useState(false);
  const [failure, setFailure] = useState<unknown>(null);
  const reopen = () => {
    setBusy(true);
    setFailure(null);
    takeStep(task.id, { action: "reopen", reason })
      .then(onDone, setFailure)
      .finally(() => setBusy(false));
  };
  return (
    <Modal opened onClose={onClose} title={`Reopen task ${task.id}`}>
      <Stack gap={12}>
        <Textarea
          label="Reason"
          description="The task goes back to its assignee; exports leave it out until it is accepted again."
          autosize
          minRows={2}
          data-autofocus
          value={reason}
          onChange={(event) => setReason(event.currentTarget.value)}
        />
        {failure !== null && <ProblemNotice error={failure} />}
        <Group justify="flex-end" gap={8}>
          <Button variant="default" onClick={onClose}>
            Cancel
          </Button>
          <Button loading={busy} disabled={reason.trim() === ""} onClick={reopen}>
            Reopen
          </Button>
        </Group>
      </Stack>
    </Modal>
  );
}

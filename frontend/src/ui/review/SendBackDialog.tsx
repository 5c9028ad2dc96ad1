import { Button, Group, Modal, Stack, Textarea } from "@mantine/core";
import { useState } from "react";
import type { Task } from "../../api/types";
import { ProblemNotice } from "../parts/ProblemNotice";
import { KIND_WORDS } from "../parts/words";
import { type RemarkIn, sendBack } from "./steps";

interface SendBackDialogProperties {
  task: Task;
  revision: number;
  remarks?: readonly RemarkIn[];
  onClose: () => void;
  onDone: (task: Task) => void;
}

/** The reason goes to the annotator with the task; remarks are shown beside their elements. */
export function SendBackDialog({ task, revision, remarks = [], onClose, onDone }: SendBackDialogProperties) {
  const [reason, setReason] = useState("");
  const [busy, setBusy] = useState(false);
  const [failure, setFailure] = useState<unknown>(null);
  const send = () => {
    setBusy(true);
    setFailure(null);
    sendBack(task, revision, reason, [...remarks])
      .then(onDone, setFailure)
      .finally(() => setBusy(false));
  };
  return (
    <Modal opened onClose={onClose} title={`Send task ${task.id} back`}>
      <Stack gap={12}>
        <Textarea
          label="Reason"
          description="Say what to change, so that the next person can act on it."
          autosize
          minRows={3}
          maxRows={10}
          data-autofocus
          value={reason}
          onChange={(event) => setReason(event.currentTarget.value)}
          onKeyDown={(event) => {
            if (event.key === "Enter" && (event.ctrlKey || event.metaKey) && reason.trim() !== "") send();
          }}
        />
        {remarks.length > 0 && (
          <div>
            <span className="label">Remarks on elements</span>
            {remarks.map((remark) => (
              <p key={`${remark.kind}:${remark.element_id}`}>
                <span className="second">
                  {KIND_WORDS[remark.kind]} {remark.element_id}:
                </span>{" "}
                {remark.text}
              </p>
            ))}
          </div>
        )}
        {failure !== null && <ProblemNotice error={failure} />}
        <Group justify="flex-end" gap={8}>
          <Button variant="default" onClick={onClose}>
            Cancel
          </Button>
          <Button color="red" variant="light" loading={busy} disabled={reason.trim() === ""} onClick={send}>
            Send back
          </Button>
        </Group>
      </Stack>
    </Modal>
  );
}

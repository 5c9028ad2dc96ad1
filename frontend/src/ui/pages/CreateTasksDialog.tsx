import { Button, Group, Modal, Select, Stack } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useState } from "react";
import { listPeople } from "../../api/accounts";
import { createTask } from "../../api/tasks";
import type { Direction } from "../../api/types";
import { counted, DIRECTION_WORDS, shortLogName } from "../parts/words";
import { tell } from "../shell/tell";
import { BulkFailures } from "./BulkFailures";
import { useBulk } from "./useBulk";

interface CreateTasksDialogProperties {
  logIds: readonly string[];
  onClose: () => void;
  onDone: () => void;
}

export function CreateTasksDialog({ logIds, onClose, onDone }: CreateTasksDialogProperties) {
  const people = useQuery({ queryKey: ["people"], queryFn: listPeople });
  const [assignee, setAssignee] = useState<string | null>(null);
  const [direction, setDirection] = useState<string | null>(null);
  const bulk = useBulk((logId: string) =>
    createTask({
      log_id: logId,
      ...(direction !== null && { direction: direction as Direction }),
      ...(assignee !== null && { assignee_id: Number(assignee) }),
    }),
  );
  const create = async () => {
    if (!(await bulk.run(logIds))) return;
    tell(`${counted(logIds.length, "task")} created.`);
    onDone();
  };
  return (
    <Modal opened onClose={onClose} title={`Create ${counted(logIds.length, "task")}`}>
      <Stack gap={12}>
        <p className="second">One new task for each chosen log, forked from its imported map.</p>
        <Select
          label="Assignee"
          placeholder="Nobody yet"
          clearable
          searchable
          data={(people.data ?? []).map((person) => ({ value: String(person.id), label: person.name }))}
          value={assignee}
          onChange={setAssignee}
        />
        <Select
          label="Edits"
          placeholder="Each log's own direction"
          clearable
          data={Object.entries(DIRECTION_WORDS).map(([value, label]) => ({ value, label }))}
          value={direction}
          onChange={setDirection}
        />
        <BulkFailures failures={bulk.failures} name={shortLogName} />
        <Group justify="flex-end" gap={8}>
          <Button variant="default" onClick={bulk.failures.length > 0 ? onDone : onClose}>
            {bulk.failures.length > 0 ? "Close" : "Cancel"}
          </Button>
          <Button
            loading={bulk.done !== null}
            disabled={bulk.failures.length > 0}
            onClick={() => void create()}
          >
            Create
          </Button>
        </Group>
        {bulk.done !== null && (
          <p className="second" role="status">{`${bulk.done} of ${logIds.length} done`}</p>
        )}
      </Stack>
    </Modal>
  );
}

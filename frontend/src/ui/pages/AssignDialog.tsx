import { Button, Group, Modal, Select, Stack } from "@mantine/core";
import { useState } from "react";
import { assignTask } from "../../api/tasks";
import type { Person } from "../../api/types";
import { counted } from "../parts/words";
import { BulkFailures } from "./BulkFailures";
import { useBulk } from "./useBulk";

interface AssignDialogProperties {
  ids: readonly number[];
  people: readonly Person[];
  onClose: () => void;
  onDone: () => void;
}

const NOBODY = "nobody";

export function AssignDialog({ ids, people, onClose, onDone }: AssignDialogProperties) {
  const [to, setTo] = useState<string | null>(null);
  const bulk = useBulk((id: number) => assignTask(id, to === NOBODY ? null : Number(to)));
  const assign = async () => {
    if (await bulk.run(ids)) onDone();
  };
  return (
    <Modal opened onClose={onClose} title={`Assign ${counted(ids.length, "task")}`}>
      <Stack gap={12}>
        <Select
          label="To"
          placeholder="Choose a person"
          searchable
          data={[
            ...people.map((person) => ({ value: String(person.id), label: person.name })),
            { value: NOBODY, label: "Nobody (take them back)" },
          ]}
          value={to}
          onChange={setTo}
          data-autofocus
        />
        <BulkFailures failures={bulk.failures} name={(id) => `Task ${id}`} />
        <Group justify="flex-end" gap={8}>
          <Button variant="default" onClick={bulk.failures.length > 0 ? onDone : onClose}>
            {bulk.failures.length > 0 ? "Close" : "Cancel"}
          </Button>
          <Button disabled={to === null} loading={bulk.done !== null} onClick={() => void assign()}>
            Assign
          </Button>
        </Group>
        {bulk.done !== null && <p className="second" role="status">{`${bulk.done} of ${ids.length} done`}</p>}
      </Stack>
    </Modal>
  );
}

import { Button, Group, Modal, Select, Stack, TextInput } from "@mantine/core";
import { type SubmitEvent, useState } from "react";
import { createAccount } from "../../api/accounts";
import type { Role } from "../../api/types";
import { ProblemNotice } from "../parts/ProblemNotice";
import { NewPasswordField } from "./NewPasswordField";
import { ROLES } from "./PersonRow";
import { MIN_PASSWORD_LENGTH } from "./password";

const NAME = /^[\w.@+-]+$/;

export function AddPersonDialog({ onClose, onAdded }: { onClose: () => void; onAdded: () => void }) {
  const [name, setName] = useState("");
  const [role, setRole] = useState<Role>("annotator");
  const [password, setPassword] = useState("");
  const [busy, setBusy] = useState(false);
  const [failure, setFailure] = useState<unknown>(null);
  const nameFault = name === "" || NAME.test(name) ? null : "Letters, digits and . _ @ + - only.";

  const add = (event: SubmitEvent) => {
    event.preventDefault();
    setBusy(true);
    setFailure(null);
    createAccount({ name, role, password })
      .then(onAdded, setFailure)
      .finally(() => setBusy(false));
  };
  return (
    <Modal opened onClose={onClose} title="Add a person">
      <form onSubmit={add}>
        <Stack gap={12}>
          <TextInput
            label="Name"
            data-autofocus
            autoComplete="off"
            spellCheck={false}
            value={name}
            error={nameFault}
            onChange={(event) => setName(event.currentTarget.value)}
          />
          <Select
            label="Role"
            data={ROLES}
            value={role}
            allowDeselect={false}
            onChange={(value) => value !== null && setRole(value as Role)}
          />
          <NewPasswordField value={password} onChange={setPassword} />
          {failure !== null && <ProblemNotice error={failure} />}
          <Group justify="flex-end" gap={8}>
            <Button variant="default" onClick={onClose}>
              Cancel
            </Button>
            <Button
              type="submit"
              loading={busy}
              disabled={name === "" || nameFault !== null || password.length < MIN_PASSWORD_LENGTH}
            >
              Add
            </Button>
          </Group>
        </Stack>
      </form>
    </Modal>
  );
}

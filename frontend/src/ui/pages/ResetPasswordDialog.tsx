import { Button, Group, Modal, Stack } from "@mantine/core";
import { useState } from "react";
import { changeAccount } from "../../api/accounts";
import type { Account } from "../../api/types";
import { ProblemNotice } from "../parts/ProblemNotice";
import { tell } from "../shell/tell";
import { NewPasswordField } from "./NewPasswordField";
import { MIN_PASSWORD_LENGTH, newPassword } from "./password";

export function ResetPasswordDialog({ account, onClose }: { account: Account; onClose: () => void }) {
  const [password, setPassword] = useState(newPassword);
  const [busy, setBusy] = useState(false);
  const [failure, setFailure] = useState<unknown>(null);
  const reset = () => {
    setBusy(true);
    setFailure(null);
    changeAccount(account.id, { password })
      .then(() => {
        tell(`${account.name} has a new password and is signed out everywhere.`);
        onClose();
      }, setFailure)
      .finally(() => setBusy(false));
  };
  return (
    <Modal opened onClose={onClose} title={`New password for ${account.name}`}>
      <Stack gap={12}>
        <NewPasswordField value={password} onChange={setPassword} />
        {failure !== null && <ProblemNotice error={failure} />}
        <Group justify="flex-end" gap={8}>
          <Button variant="default" onClick={onClose}>
            Cancel
          </Button>
          <Button loading={busy} disabled={password.length < MIN_PASSWORD_LENGTH} onClick={reset}>
            Set this password
          </Button>
        </Group>
      </Stack>
    </Modal>
  );
}

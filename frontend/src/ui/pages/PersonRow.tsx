import { Button, Group, Select } from "@mantine/core";
import { useState } from "react";
import { type AccountChange, changeAccount } from "../../api/accounts";
import type { Account, Role } from "../../api/types";
import { Badge } from "../parts/Badge";
import { day, ROLE_WORDS } from "../parts/words";
import { tellProblem } from "../shell/tell";
import { useSession } from "../useSession";

interface PersonRowProperties {
  account: Account;
  onChanged: () => void;
  onReset: (account: Account) => void;
}

export const ROLES = Object.entries(ROLE_WORDS).map(([value, label]) => ({ value, label }));

export function PersonRow({ account, onChanged, onReset }: PersonRowProperties) {
  const own = useSession().account.id === account.id;
  const [busy, setBusy] = useState(false);
  const disabled = account.disabled_at !== null;
  const change = (patch: AccountChange) => {
    setBusy(true);
    changeAccount(account.id, patch)
      .then(onChanged, tellProblem)
      .finally(() => setBusy(false));
  };
  return (
    <tr>
      <td>
        {account.name} {own && <span className="third">(you)</span>}
      </td>
      <td>
        <Select
          aria-label={`Role of ${account.name}`}
          data={ROLES}
          value={account.role}
          allowDeselect={false}
          disabled={busy || own}
          w={130}
          onChange={(role) => role !== null && change({ role: role as Role })}
        />
      </td>
      <td>{day(account.created_at)}</td>
      <td>{disabled ? <Badge tone="error">disabled</Badge> : <Badge tone="ok">active</Badge>}</td>
      <td>
        <Group gap={8} justify="flex-end" wrap="nowrap">
          <Button variant="default" onClick={() => onReset(account)}>
            Reset password
          </Button>
          <Button
            variant="default"
            disabled={own}
            loading={busy}
            onClick={() => change({ disabled: !disabled })}
          >
            {disabled ? "Enable" : "Disable"}
          </Button>
        </Group>
      </td>
    </tr>
  );
}

import { Button, Checkbox, Group, NumberInput, TextInput } from "@mantine/core";
import { type SubmitEvent, useState } from "react";
import { createToken } from "../../api/tokens";
import type { TokenCreated } from "../../api/types";
import { ProblemNotice } from "../parts/ProblemNotice";
import classes from "./pages.module.css";
import { SCOPES } from "./scopes";

export function NewToken({ onCreated }: { onCreated: (token: TokenCreated) => void }) {
  const [name, setName] = useState("");
  const [scopes, setScopes] = useState<string[]>(["export:read"]);
  const [days, setDays] = useState<number | string>(90);
  const [busy, setBusy] = useState(false);
  const [failure, setFailure] = useState<unknown>(null);
  const create = (event: SubmitEvent) => {
    event.preventDefault();
    setBusy(true);
    setFailure(null);
    createToken({ name: name.trim(), scopes, days: Number(days) })
      .then((token) => {
        setName("");
        onCreated(token);
      }, setFailure)
      .finally(() => setBusy(false));
  };
  return (
    <form onSubmit={create} aria-label="New token">
      <div className={classes.row}>
        <TextInput
          label="Name"
          placeholder="training cluster"
          w={180}
          maxLength={100}
          value={name}
          onChange={(event) => setName(event.currentTarget.value)}
        />
        <NumberInput
          label="Expires after, days"
          w={130}
          min={1}
          max={366}
          allowDecimal={false}
          value={days}
          onChange={setDays}
        />
        <Checkbox.Group label="May" value={scopes} onChange={setScopes}>
          <Group gap={12} h={30}>
            {SCOPES.map((scope) => (
              <Checkbox key={scope.value} value={scope.value} label={scope.label} />
            ))}
          </Group>
        </Checkbox.Group>
        <Button
          type="submit"
          loading={busy}
          disabled={name.trim() === "" || scopes.length === 0 || !(Number(days) >= 1)}
        >
          Create
        </Button>
      </div>
      {failure !== null && <ProblemNotice error={failure} />}
    </form>
  );
}

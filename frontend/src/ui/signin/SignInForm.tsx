import { Button, PasswordInput, TextInput } from "@mantine/core";
import { type SubmitEvent, useState } from "react";
import { signIn } from "../../api/session";
import type { Session } from "../../api/types";
import { ProblemNotice } from "../parts/ProblemNotice";
import classes from "./signin.module.css";

interface SignInFormProperties {
  initialName?: string;
  onSignedIn: (session: Session) => void;
}

export function SignInForm({ initialName = "", onSignedIn }: SignInFormProperties) {
  const [name, setName] = useState(initialName);
  const [password, setPassword] = useState("");
  const [busy, setBusy] = useState(false);
  const [failure, setFailure] = useState<unknown>(null);

  const submit = async (event: SubmitEvent) => {
    event.preventDefault();
    setBusy(true);
    setFailure(null);
    try {
      onSignedIn(await signIn(name.trim(), password));
    } catch (error) {
      setFailure(error);
      setPassword("");
    } finally {
      setBusy(false);
    }
  };

  return (
    <form className={classes.form} onSubmit={(event) => void submit(event)}>
      <TextInput
        label="Name"
        value={name}
        autoComplete="username"
        autoCapitalize="none"
        spellCheck={false}
        size="sm"
        required
        withAsterisk={false}
        data-autofocus={initialName === "" || undefined}
        autoFocus={initialName === ""}
        onChange={(event) => setName(event.currentTarget.value)}
      />
      <PasswordInput
        label="Password"
        value={password}
        autoComplete="current-password"
        size="sm"
        required
        withAsterisk={false}
        data-autofocus={initialName !== "" || undefined}
        onChange={(event) => setPassword(event.currentTarget.value)}
      />
      {failure !== null && <ProblemNotice error={failure} />}
      <Button type="submit" size="sm" loading={busy} disabled={name.trim() === "" || password === ""}>
        Sign in
      </Button>
    </form>
  );
}

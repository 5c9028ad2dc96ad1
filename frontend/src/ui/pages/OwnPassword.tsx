import { Button, PasswordInput } from "@mantine/core";
import { type SubmitEvent, useState } from "react";
import { changePassword } from "../../api/session";
import { ProblemNotice } from "../parts/ProblemNotice";
import { tell } from "../shell/tell";
import classes from "./pages.module.css";
import { MIN_PASSWORD_LENGTH, passwordFault } from "./password";

export function OwnPassword() {
  const [current, setCurrent] = useState("");
  const [next, setNext] = useState("");
  const [busy, setBusy] = useState(false);
  const [failure, setFailure] = useState<unknown>(null);
  const fault = passwordFault(next);
  const change = (event: SubmitEvent) => {
    event.preventDefault();
    setBusy(true);
    setFailure(null);
    changePassword(current, next)
      .then(() => {
        setCurrent("");
        setNext("");
        tell("Your password is changed; your other browsers are signed out.");
      }, setFailure)
      .finally(() => setBusy(false));
  };
  return (
    <form className={classes.card} aria-label="Change your password" onSubmit={change}>
      <h2>Password</h2>
      <div className={classes.row}>
        <PasswordInput
          label="Current password"
          autoComplete="current-password"
          w={220}
          value={current}
          onChange={(event) => setCurrent(event.currentTarget.value)}
        />
        <PasswordInput
          label="New password"
          autoComplete="new-password"
          w={220}
          value={next}
          error={fault !== null}
          onChange={(event) => setNext(event.currentTarget.value)}
        />
        <Button type="submit" loading={busy} disabled={current === "" || next.length < MIN_PASSWORD_LENGTH}>
          Change
        </Button>
      </div>
      <p className="third small" role="status">
        {fault ?? `At least ${MIN_PASSWORD_LENGTH} characters. Changing it signs out your other browsers.`}
      </p>
      {failure !== null && <ProblemNotice error={failure} />}
    </form>
  );
}

import { Button } from "@mantine/core";
import { useState } from "react";
import { signIn } from "../../api/session";
import type { Role, Session } from "../../api/types";
import { ProblemNotice } from "../parts/ProblemNotice";
import classes from "./signin.module.css";

/** As `lanewright demo` makes them; the server lets them in only while nobody else can reach it. */
const DEMO_PASSWORD = "lanewright-demo";
const DEMO_PEOPLE: readonly Role[] = ["annotator", "reviewer", "admin"];

export function DemoSignIns({ onSignedIn }: { onSignedIn: (session: Session) => void }) {
  const [busy, setBusy] = useState<Role | null>(null);
  const [failure, setFailure] = useState<unknown>(null);

  const enter = async (role: Role) => {
    setBusy(role);
    setFailure(null);
    try {
      onSignedIn(await signIn(role, DEMO_PASSWORD));
    } catch (error) {
      setFailure(error);
    } finally {
      setBusy(null);
    }
  };

  return (
    <section className={classes.demo} aria-label="Demo sign-ins">
      <p className="second small">This server runs the demo. Look around as</p>
      <div className={classes.people}>
        {DEMO_PEOPLE.map((role) => (
          <Button
            key={role}
            variant="default"
            loading={busy === role}
            disabled={busy !== null && busy !== role}
            onClick={() => void enter(role)}
          >
            {role}
          </Button>
        ))}
      </div>
      {failure !== null && <ProblemNotice error={failure} />}
    </section>
  );
}

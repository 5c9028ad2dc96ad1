import { Button } from "@mantine/core";
import { Link } from "wouter";
import { ProblemNotice } from "../parts/ProblemNotice";

export function OpenFailed({ error, onRetry }: { error: unknown; onRetry: () => void }) {
  return (
    <main className="centred">
      <h1>The task could not be opened</h1>
      <ProblemNotice error={error} onRetry={onRetry} />
      <Button component={Link} href="/" variant="default">
        My tasks
      </Button>
    </main>
  );
}

import { Button } from "@mantine/core";
import { asProblem } from "../../api/problem";
import classes from "./parts.module.css";

/** What went wrong, what mends it, and the request id for whoever looks into the server's log. */
export function ProblemNotice({ error, onRetry }: { error: unknown; onRetry?: () => void }) {
  const problem = asProblem(error);
  return (
    <div className={classes.problem} role="alert">
      <span className={classes.problemMessage}>{problem.message}</span>
      {problem.mend !== "" && <span>{problem.mend}</span>}
      {onRetry && (
        <span>
          <Button variant="default" onClick={onRetry}>
            Try again
          </Button>
        </span>
      )}
      {problem.requestId !== "" && <span className={classes.problemId}>request {problem.requestId}</span>}
    </div>
  );
}

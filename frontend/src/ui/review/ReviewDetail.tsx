import { Button } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { getFindings } from "../../api/tasks";
import type { Task } from "../../api/types";
import { ChangeList } from "../changes/ChangeList";
import { Loading } from "../parts/Loading";
import { ProblemNotice } from "../parts/ProblemNotice";
import { counted, DIRECTION_WORDS, shortLogName } from "../parts/words";
import { DifferencePreview } from "./DifferencePreview";
import classes from "./review.module.css";

interface ReviewDetailProperties {
  task: Task;
  busy: boolean;
  onAccept: () => void;
  onSendBack: () => void;
  onOpen: () => void;
}

/** What the chosen task changed, on the map and in words, and the decision on it. */
export function ReviewDetail({ task, busy, onAccept, onSendBack, onOpen }: ReviewDetailProperties) {
  const findings = useQuery({
    queryKey: ["findings", task.id, task.head],
    queryFn: () => getFindings(task.id, task.head),
    staleTime: Number.POSITIVE_INFINITY,
  });
  const warnings = findings.data?.violations.filter((violation) => !violation.inherited).length ?? 0;
  return (
    <aside className={classes.detail} aria-label={`Task ${task.id}`}>
      <div className={classes.preview}>
        <DifferencePreview task={task} findings={findings.data} />
      </div>
      <div className={classes.facts}>
        <h2 title={task.log_id}>{shortLogName(task.log_id)}</h2>
        <p className="mono second">
          {task.city} · {DIRECTION_WORDS[task.direction]} · revision {task.head}
        </p>
        <div className={classes.tiles}>
          <Tile
            number={task.changed_elements}
            words={`changes, ${counted(findings.data?.updates.length ?? 0, "update")}`}
          />
          <Tile number={warnings} words={warnings === 1 ? "warning" : "warnings"} />
          <Tile number={task.lanes} words={`lanes, ${counted(task.crossings, "crossing")}`} />
        </div>
        {findings.isPending && <Loading what="changes" />}
        {findings.isError && <ProblemNotice error={findings.error} onRetry={() => void findings.refetch()} />}
        {findings.data?.changes.length === 0 && (
          <p className="second">Nothing was changed: prior and current map are the same.</p>
        )}
        {findings.data && <ChangeList findings={findings.data} />}
      </div>
      <footer className={classes.decision}>
        <Button
          variant="light"
          color="green"
          rightSection={<kbd>G</kbd>}
          loading={busy}
          disabled={findings.data === undefined}
          onClick={onAccept}
        >
          Accept
        </Button>
        <Button variant="light" color="red" rightSection={<kbd>B</kbd>} onClick={onSendBack}>
          Send back
        </Button>
        <span className={classes.spring} />
        <Button variant="default" rightSection={<kbd>Enter</kbd>} onClick={onOpen}>
          Open
        </Button>
      </footer>
    </aside>
  );
}

function Tile({ number, words }: { number: number; words: string }) {
  return (
    <div className={classes.tile}>
      <strong>{number}</strong>
      <span>{words}</span>
    </div>
  );
}

import type { Task } from "../../api/types";
import { mayJudge } from "../review/steps";
import { useScreen, useWorkspace } from "./context";
import classes from "./workspace.module.css";

/** Why the map is only to look at, and whose turn it is. */
export function readingWords(task: Task, revision: number): string {
  if (revision !== task.head) return `revision ${revision} · only to look at`;
  const at = `revision ${task.head}`;
  switch (task.state) {
    case "submitted":
      return mayJudge(task) ? `${at} · waits for your review` : `${at} · waits for a reviewer`;
    case "in_review":
      return `${at} · ${mayJudge(task) ? "for you to decide" : `${task.reviewer?.name ?? "a reviewer"} reviews it`}`;
    case "accepted":
      return `revision ${task.accepted_revision ?? task.head} is accepted and exported`;
    default:
      return `${at} · ${task.assignee === null ? "nobody" : task.assignee.name} edits it`;
  }
}

export function ReadingStatus() {
  const { workspace } = useWorkspace();
  const task = useScreen((state) => state.task);
  return (
    <span className={classes.saving} role="status">
      <span className={classes.savingText}>{readingWords(task, workspace.revision)}</span>
    </span>
  );
}

import { takeStep } from "../../api/tasks";
import type { Step, Task } from "../../api/types";

/** What a reviewer decides; a task that nobody reviews yet is taken into review first. */
async function decide(task: Task, step: Step): Promise<Task> {
  if (task.state === "submitted") await takeStep(task.id, { action: "start_review" });
  return await takeStep(task.id, step);
}

/** Accepts the revision that was looked at; the server refuses when the task has moved on. */
export const accept = (task: Task, revision: number) => decide(task, { action: "accept", revision });

export type RemarkIn = NonNullable<Step["remarks"]>[number];

export const sendBack = (task: Task, revision: number, reason: string, remarks: RemarkIn[]) =>
  decide(task, { action: "send_back", revision, reason, remarks });

/** Whether the asker may judge the task now. */
export const mayJudge = (task: Task): boolean =>
  task.actions.some((action) => action === "start_review" || action === "accept" || action === "send_back");

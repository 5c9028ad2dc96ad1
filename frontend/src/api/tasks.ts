import { ask, client } from "./client";
import type { Direction, Findings, Step, Task, TaskPage, TaskState } from "./types";

export interface TaskFilter {
  q?: string;
  /** "me", "nobody" or an account's id; left out: anybody. */
  assignee?: string;
  state?: TaskState[];
  city?: string;
  split?: string;
  /** Only what the asker may review now. */
  reviewable?: boolean;
  sort?: "newest" | "waiting" | "log";
  page?: number;
  page_size?: number;
}

const path = (id: number) => ({ path: { task_id: id } });

export const listTasks = (query: TaskFilter): Promise<TaskPage> =>
  ask(() => client.GET("/api/v1/tasks", { params: { query } }));

export const getTask = (id: number): Promise<Task> =>
  ask(() => client.GET("/api/v1/tasks/{task_id}", { params: path(id) }));

export interface NewTask {
  log_id: string;
  /** Left out: the log's own. */
  direction?: Direction;
  assignee_id?: number;
}

export const createTask = (body: NewTask): Promise<Task> => ask(() => client.POST("/api/v1/tasks", { body }));

/** null takes the task from whoever has it. */
export const assignTask = (id: number, assignee: number | null): Promise<Task> =>
  ask(() => client.PATCH("/api/v1/tasks/{task_id}", { params: path(id), body: { assignee_id: assignee } }));

export const takeStep = (id: number, step: Step): Promise<Task> =>
  ask(() => client.POST("/api/v1/tasks/{task_id}/steps", { params: path(id), body: step }));

/** Everything that revision changed against the imported map. */
export const getFindings = (id: number, revision: number): Promise<Findings> =>
  ask(() =>
    client.GET("/api/v1/tasks/{task_id}/revisions/{revision}/findings", {
      params: { path: { task_id: id, revision } },
    }),
  );

import { ask, client } from "./client";
import type {
  CanonicalForm,
  Declaration,
  DraftKept,
  Drive,
  Edit,
  Findings,
  IdBlock,
  SavedRevision,
  Workspace,
} from "./types";

const path = (id: number) => ({ path: { task_id: id } });

/** Default revision: the head. */
export const openWorkspace = (id: number, revision?: number): Promise<Workspace> =>
  ask(() =>
    client.GET("/api/v1/tasks/{task_id}/workspace", {
      params: { ...path(id), ...(revision === undefined ? {} : { query: { revision } }) },
    }),
  );

export const getDrive = (id: number): Promise<Drive> =>
  ask(() => client.GET("/api/v1/tasks/{task_id}/drive", { params: path(id) }));

export const takeIdBlock = (id: number): Promise<IdBlock> =>
  ask(() => client.POST("/api/v1/tasks/{task_id}/id-blocks", { params: path(id) }));

/** Edits since the base revision, and all declarations of macros, as sent to be kept, checked or saved. */
export interface DraftBody {
  base_revision: number;
  edits: Edit[];
  declarations: Declaration[];
}

export const keepDraft = (id: number, body: DraftBody & { version: number }): Promise<DraftKept> =>
  ask(() => client.PUT("/api/v1/tasks/{task_id}/draft", { params: path(id), body }));

export const dropDraft = (id: number): Promise<unknown> =>
  ask(() => client.DELETE("/api/v1/tasks/{task_id}/draft", { params: path(id) }));

export const checkDraft = (id: number, body: DraftBody, signal: AbortSignal): Promise<Findings> =>
  ask(() => client.POST("/api/v1/tasks/{task_id}/check", { params: path(id), body, signal }));

/** What takes the draft to its canonical form; nothing is written. */
export const canonicalForm = (id: number, body: DraftBody): Promise<CanonicalForm> =>
  ask(() => client.POST("/api/v1/tasks/{task_id}/canonical", { params: path(id), body }));

export type SaveBody = DraftBody & { changeset_uuid: string; note: string };

export const saveRevision = (id: number, body: SaveBody): Promise<SavedRevision> =>
  ask(() => client.POST("/api/v1/tasks/{task_id}/revisions", { params: path(id), body }));

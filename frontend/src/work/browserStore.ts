/** What is kept on this computer: drafts, drafts set aside, and remarks of a review that is under way. */
import { type DBSchema, type IDBPDatabase, openDB } from "idb";
import type { Remark } from "../api/types";
import type { SaveBody } from "../api/workspace";
import type { Declaration, Edit, History, ReceivedEdit } from "../editor";

/** One person's work in one task. */
export interface WorkKey {
  account: number;
  task: number;
}

export const workKey = ({ account, task }: WorkKey) => `${account}:${task}`;

export interface LocalDraft {
  format: 1;
  baseRevision: number;
  edits: Edit[];
  /** All declarations of macros; null, or left out by an older version: those of the base revision. */
  declarations?: Declaration[] | null;
  history: History | null;
  /** The server's draft that this one goes on from; 0: none. */
  serverVersion: number;
  /** Whether the server holds exactly these edits as `serverVersion`. */
  synced: boolean;
  changedAt: number;
  /** A save that was sent and not answered yet: sent again unchanged, it is answered alike. */
  sent: SaveBody | null;
}

/** A draft that the user did not choose, kept all the same. */
export interface ParkedDraft {
  owner: string;
  parkedAt: number;
  reason: string;
  baseRevision: number;
  edits: readonly (Edit | ReceivedEdit)[];
  declarations: readonly Declaration[] | null;
}

interface Schema extends DBSchema {
  drafts: { key: string; value: LocalDraft };
  parked: { key: number; value: ParkedDraft; indexes: { owner: string } };
  remarks: { key: string; value: Remark[] };
}

let opened: Promise<IDBPDatabase<Schema>> | null = null;

function database(): Promise<IDBPDatabase<Schema>> {
  opened ??= openDB<Schema>("lanewright", 1, {
    upgrade(db) {
      db.createObjectStore("drafts");
      db.createObjectStore("parked", { autoIncrement: true }).createIndex("owner", "owner");
      db.createObjectStore("remarks");
    },
    terminated() {
      opened = null;
    },
  });
  return opened;
}

export async function readDraft(key: WorkKey): Promise<LocalDraft | null> {
  return (await (await database()).get("drafts", workKey(key))) ?? null;
}

export async function writeDraft(key: WorkKey, draft: LocalDraft): Promise<void> {
  await (await database()).put("drafts", draft, workKey(key));
}

export async function removeDraft(key: WorkKey): Promise<void> {
  await (await database()).delete("drafts", workKey(key));
}

export async function parkDraft(key: WorkKey, draft: Omit<ParkedDraft, "owner" | "parkedAt">): Promise<void> {
  await (await database()).add("parked", { ...draft, owner: workKey(key), parkedAt: Date.now() });
}

/** Newest first, by their keys. */
export async function parkedDrafts(key: WorkKey): Promise<{ id: number; draft: ParkedDraft }[]> {
  const store = (await database()).transaction("parked").store.index("owner");
  const found: { id: number; draft: ParkedDraft }[] = [];
  for await (const cursor of store.iterate(workKey(key))) {
    found.unshift({ id: cursor.primaryKey, draft: cursor.value });
  }
  return found;
}

export async function removeParked(id: number): Promise<void> {
  await (await database()).delete("parked", id);
}

export async function readRemarks(key: WorkKey): Promise<Remark[]> {
  return (await (await database()).get("remarks", workKey(key))) ?? [];
}

export async function writeRemarks(key: WorkKey, remarks: Remark[]): Promise<void> {
  const db = await database();
  if (remarks.length === 0) await db.delete("remarks", workKey(key));
  else await db.put("remarks", remarks, workKey(key));
}

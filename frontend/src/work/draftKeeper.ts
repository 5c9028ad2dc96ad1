/**
 * Keeps the draft: every edit at once on this computer, and within two seconds on the server. Neither copy is
 * cleared before the server has answered the save (or the user has undone everything).
 */
import type { StoreApi } from "zustand/vanilla";
import { asProblem } from "../api/problem";
import type { Draft } from "../api/types";
import { dropDraft, keepDraft, type SaveBody } from "../api/workspace";
import { type DraftContent, type Edit, type Editor, merged, sameDeclarations } from "../editor";
import { backoffMs } from "./backoff";
import { removeDraft, type WorkKey, writeDraft } from "./browserStore";
import type { Keeping, StaleBase, WorkState } from "./workState";

const PUSH_AFTER_MS = 2_000;

export interface KeptSoFar {
  serverVersion: number;
  synced: boolean;
  sent: SaveBody | null;
}

export class DraftKeeper {
  private draft: DraftContent;
  private serverVersion: number;
  private sent: SaveBody | null;
  /** Whether there is something that the server has not. */
  private dirty: boolean;
  private changedAt = Date.now();
  private failures = 0;
  private timer: ReturnType<typeof setTimeout> | null = null;
  private pushing: Promise<void> | null = null;
  private paused = false;
  private stopped = true;
  private writing: Promise<void> = Promise.resolve();
  private writeQueued = false;

  constructor(
    private readonly key: WorkKey,
    private readonly editor: Editor,
    private readonly store: StoreApi<WorkState>,
    kept: KeptSoFar,
  ) {
    this.draft = editor.actions.netDraft();
    this.serverVersion = kept.serverVersion;
    this.sent = kept.sent;
    this.dirty = !kept.synced && !this.empty;
  }

  start(): void {
    this.stopped = false;
    globalThis.addEventListener("online", this.pushNow);
    if (this.dirty) this.schedule(0);
  }

  stop(): void {
    this.stopped = true;
    this.cancelTimer();
    globalThis.removeEventListener("online", this.pushNow);
  }

  private get empty(): boolean {
    return this.draft.edits.length === 0 && this.draft.declarations === null;
  }

  /** The map, or what is declared of it, has changed. */
  note(draft: DraftContent): void {
    this.draft = draft;
    this.changedAt = Date.now();
    this.dirty = true;
    this.show(this.empty ? { where: "nothing" } : { where: "computer" });
    void this.persist();
    this.schedule(PUSH_AFTER_MS);
  }

  /** Before a save: no draft may reach the server after it. Resolves when none is under way. */
  async hold(body: SaveBody): Promise<void> {
    this.paused = true;
    this.cancelTimer();
    await this.pushing;
    this.sent = body;
    await this.persist();
  }

  /** The save was refused, or its answer is given up for now (`undecided`: then it stays to be sent again). */
  async release(undecided: boolean): Promise<void> {
    this.paused = false;
    if (!undecided) this.sent = null;
    await this.persist();
    if (this.dirty) this.schedule(0);
  }

  /** The server has answered the save, and dropped its draft with it; `draft`: what was made since. */
  async saved(draft: DraftContent): Promise<void> {
    this.paused = false;
    this.sent = null;
    this.serverVersion = 0;
    this.draft = draft;
    this.dirty = !this.empty;
    this.show(this.dirty ? { where: "computer" } : { where: "nothing" });
    await this.persist();
    if (this.dirty) this.schedule(0);
  }

  /** This window's draft is to replace the newer one that the server holds. */
  replace(newer: Draft): void {
    this.serverVersion = newer.version;
    this.dirty = true;
    this.store.setState({ newerDraft: null });
    this.schedule(0);
  }

  /** After `stop`: leaves a draft on a newer base for the next opening, or none where nothing is left of it. */
  async rebase({ head, declarations: theirs }: StaleBase, edits: Edit[]): Promise<void> {
    const { declarations: mine } = this.draft;
    const stated = mine && merged(this.editor.getState().savedDeclarations, theirs, mine);
    const declarations = stated && sameDeclarations(stated, theirs) ? null : stated;
    await this.pushing;
    await this.writing;
    if (edits.length === 0 && declarations === null) {
      if (this.serverVersion !== 0) await dropDraft(this.key.task);
      await removeDraft(this.key);
      return;
    }
    await writeDraft(this.key, {
      format: 1,
      baseRevision: head,
      edits,
      declarations,
      history: null,
      serverVersion: this.serverVersion,
      synced: false,
      changedAt: Date.now(),
      sent: null,
    });
  }

  private persist(): Promise<void> {
    if (this.writeQueued) return this.writing;
    this.writeQueued = true;
    this.writing = this.writing.then(() => this.write());
    return this.writing;
  }

  private async write(): Promise<void> {
    this.writeQueued = false;
    const { savedRevision, history } = this.editor.getState();
    try {
      if (this.empty && this.sent === null) {
        await removeDraft(this.key);
        return;
      }
      await writeDraft(this.key, {
        format: 1,
        baseRevision: savedRevision,
        ...this.draft,
        history,
        serverVersion: this.serverVersion,
        synced: !this.dirty,
        changedAt: this.changedAt,
        sent: this.sent,
      });
    } catch (error) {
      // The server's copy is all there is then; the header says so until it is kept there.
      if (this.dirty) this.show({ where: "nowhere", problem: asProblem(error) });
      this.pushNow();
    }
  }

  private schedule(afterMs: number): void {
    if (this.stopped || this.paused || this.pushing !== null) return;
    if (this.timer !== null && afterMs > 0) return;
    this.cancelTimer();
    this.timer = setTimeout(this.pushNow, afterMs);
  }

  private cancelTimer(): void {
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = null;
  }

  private readonly pushNow = (): void => {
    this.cancelTimer();
    if (this.stopped || this.paused || !this.dirty || this.pushing !== null) return;
    this.pushing = this.push().then((againAfterMs) => {
      this.pushing = null;
      if (againAfterMs !== null) this.schedule(againAfterMs);
    });
  };

  /** One attempt; resolves to the wait before the next, or null when there is nothing more to do by itself. */
  private async push(): Promise<number | null> {
    this.dirty = false;
    try {
      await this.pushDraft();
      this.failures = 0;
      if (this.changedSince()) return PUSH_AFTER_MS;
      this.show(this.empty ? { where: "nothing" } : { where: "server", at: Date.now() });
      await this.persist();
      return null;
    } catch (error) {
      this.dirty = true;
      const problem = asProblem(error);
      if (problem.passing) {
        this.failures += 1;
        this.show({ where: "offline" });
        return backoffMs(this.failures);
      }
      if (problem.code === "draft.superseded") {
        // Another device has saved since; this draft is more than a late copy of that, so it is kept all the same.
        this.serverVersion = problem.facts.version as number;
        return 0;
      }
      const newer = problem.code === "draft.newer" ? (problem.facts.draft as Draft | null) : undefined;
      if (newer === null) {
        this.serverVersion = 0;
        return 0;
      }
      this.show({ where: "refused", problem });
      if (newer !== undefined) this.store.setState({ newerDraft: newer });
      return null;
    }
  }

  /** Whether edits were noted while a push was under way. */
  private changedSince(): boolean {
    return this.dirty;
  }

  private async pushDraft(): Promise<void> {
    const { edits, declarations } = this.draft;
    if (this.empty) {
      if (this.serverVersion !== 0) await dropDraft(this.key.task);
      this.serverVersion = 0;
      return;
    }
    const { savedRevision, savedDeclarations } = this.editor.getState();
    const kept = await keepDraft(this.key.task, {
      base_revision: savedRevision,
      edits,
      declarations: declarations ?? [...savedDeclarations],
      version: this.serverVersion,
    });
    this.serverVersion = kept.version;
  }

  private show(keeping: Keeping): void {
    this.store.setState({ keeping });
  }
}

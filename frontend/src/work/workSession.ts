/** An editable task that is open: its editor, its draft, its live check and its saves. */
import { createStore, type StoreApi } from "zustand/vanilla";
import { asProblem, type Problem } from "../api/problem";
import type { Draft, SavedRevision, Violation } from "../api/types";
import { type SaveBody, saveRevision } from "../api/workspace";
import type { Edit, Editor, ReceivedEdit, SaveSnapshot } from "../editor";
import { backoffMs, pause } from "./backoff";
import { parkDraft, type WorkKey } from "./browserStore";
import { elementsWords } from "./canonicalWords";
import { Checker, staleBase } from "./checker";
import { DraftKeeper, type KeptSoFar } from "./draftKeeper";
import { newUuid } from "./uuid";
import { countChanges, type StaleBase, type WorkState } from "./workState";

export type SaveOutcome =
  | { kind: "saved"; saved: SavedRevision }
  | { kind: "nothing" }
  /** The base moved on and contradicts the draft: `state.stale` says where. */
  | { kind: "stale" }
  /** Rules refuse it: `state.findings` says which. */
  | { kind: "violations" }
  | { kind: "failed"; problem: Problem };

interface PendingSave {
  body: SaveBody;
  snapshot: SaveSnapshot;
}

export class WorkSession {
  readonly store: StoreApi<WorkState>;
  private readonly keeper: DraftKeeper;
  private readonly checker: Checker;
  private readonly ends = new AbortController();
  private unsubscribe: (() => void) | null = null;

  constructor(
    private readonly key: WorkKey,
    readonly editor: Editor,
    kept: KeptSoFar & { keptAt: number | null },
    /** A save that was sent before the page was closed and that nobody saw answered. */
    private pending: PendingSave | null = null,
  ) {
    const edits = countChanges(editor.actions.netDraft());
    this.store = createStore<WorkState>(() => ({
      edits,
      revision: editor.getState().savedRevision,
      keeping:
        edits === 0
          ? { where: "nothing" }
          : kept.synced && kept.keptAt !== null
            ? { where: "server", at: kept.keptAt }
            : { where: "computer" },
      saving: "no",
      findings: null,
      checking: false,
      checkProblem: null,
      stale: null,
      newerDraft: null,
      elsewhere: false,
    }));
    this.keeper = new DraftKeeper(key, editor, this.store, kept);
    this.checker = new Checker(key.task, editor, this.store);
  }

  start(): void {
    this.keeper.start();
    this.checker.note(this.editor.actions.netDraft(), 0);
    this.unsubscribe = this.editor.subscribe((state, before) => {
      const same = state.current === before.current && state.declarations === before.declarations;
      if (same || state.saved !== before.saved) return;
      const draft = this.editor.actions.netDraft();
      this.store.setState({ edits: countChanges(draft) });
      this.keeper.note(draft);
      this.checker.note(draft);
    });
  }

  /** Lets go; what is unsaved is kept. */
  stop(): void {
    this.unsubscribe?.();
    this.unsubscribe = null;
    this.keeper.stop();
    this.checker.stop();
  }

  /** For good: also gives up a save that waits for the server; it is sent again when the task is opened. */
  end(): void {
    this.stop();
    this.ends.abort();
  }

  /** Whether a save of an earlier visit waits to be sent again. */
  get hasPendingSave(): boolean {
    return this.pending !== null;
  }

  /** Turns the draft into a revision; a save whose answer is still unknown is settled first. */
  async save(note = ""): Promise<SaveOutcome> {
    if (this.store.getState().saving !== "no") return { kind: "nothing" };
    if (this.pending !== null) {
      const outcome = await this.send(this.pending);
      if (outcome.kind !== "saved" || this.store.getState().edits === 0) return outcome;
    }
    const snapshot = this.editor.actions.takeSnapshot();
    if (this.store.getState().edits === 0) return { kind: "nothing" };
    const { edits, declarations } = snapshot;
    const base_revision = this.editor.getState().savedRevision;
    const body = { base_revision, edits, declarations, changeset_uuid: newUuid(), note };
    return await this.send({ body, snapshot });
  }

  /** Ends this session with other edits for a newer base; the task is then opened anew and goes on with them. */
  async rebase(stale: StaleBase, edits: Edit[]): Promise<void> {
    this.stop();
    try {
      await this.keeper.rebase(stale, edits);
    } catch (error) {
      // Editing goes on here, so it is kept here again, with what was drawn while nobody listened.
      this.start();
      this.keeper.note(this.editor.actions.netDraft());
      throw error;
    }
  }

  /** Ends this session without its draft; the task is then opened anew, at its newest revision. */
  async discard(): Promise<void> {
    this.editor.actions.discardDraft();
    await this.rebase({ head: this.store.getState().revision, conflicts: [], declarations: [] }, []);
  }

  keepMine(newer: Draft): void {
    this.keeper.replace(newer);
  }

  private async send(pending: PendingSave): Promise<SaveOutcome> {
    this.pending = pending;
    this.store.setState({ saving: "sending" });
    await this.keeper.hold(pending.body);
    try {
      const saved = await this.sendUntilAnswered(pending.body);
      this.pending = null;
      await this.adopt(saved, pending.snapshot);
      return { kind: "saved", saved };
    } catch (error) {
      const problem = asProblem(error);
      // Without a session nobody knows whether an earlier attempt of this save was carried out.
      const undecided = problem.status === 401 || problem.status === 0;
      if (!undecided) this.pending = null;
      await this.keeper.release(undecided);
      return this.refused(problem);
    } finally {
      this.store.setState({ saving: "no" });
    }
  }

  /** The same request until the server answers it: a save that was carried out is answered as it was the first time. */
  private async sendUntilAnswered(body: SaveBody): Promise<SavedRevision> {
    for (let failures = 1; ; failures += 1) {
      try {
        return await saveRevision(this.key.task, body);
      } catch (error) {
        const problem = asProblem(error);
        if (!problem.passing || problem.code === "page.failed") throw problem;
        this.store.setState({ saving: "waiting" });
        await pause(backoffMs(failures), this.ends.signal);
        this.store.setState({ saving: "sending" });
      }
    }
  }

  private async adopt(saved: SavedRevision, snapshot: SaveSnapshot): Promise<void> {
    const unfit = this.editor.actions.adoptSaved(saved, snapshot);
    if (unfit.length > 0) await this.setAside(saved.revision, unfit);
    const draft = this.editor.actions.netDraft();
    const edits = countChanges(draft);
    this.store.setState({ edits, revision: saved.revision, stale: null });
    if (edits === 0) {
      this.checker.stop();
      this.store.setState({ findings: saved.findings, checking: false, checkProblem: null });
    } else this.checker.note(draft);
    await this.keeper.saved(draft);
  }

  /** Keeps the edits made during a save that the saved map has no place for. */
  private async setAside(baseRevision: number, edits: readonly ReceivedEdit[]): Promise<void> {
    const reason = "edited during a save that changed what they were made on";
    const names = elementsWords(edits);
    try {
      await parkDraft(this.key, { reason, baseRevision, edits, declarations: null });
      this.editor.actions.say(
        `What you edited during the save on ${names} does not fit the saved map: it is set aside under History.`,
      );
    } catch {
      this.editor.actions.say(
        `What you edited during the save on ${names} does not fit the saved map, and this computer could not keep it: do it again.`,
      );
    }
  }

  private refused(problem: Problem): SaveOutcome {
    if (problem.code === "save.stale") {
      this.store.setState({ stale: staleBase(problem.facts) });
      return { kind: "stale" };
    }
    if (problem.code === "save.violations") {
      this.showViolations(problem.facts.violations as Violation[]);
      return { kind: "violations" };
    }
    return { kind: "failed", problem };
  }

  private showViolations(refusing: Violation[]): void {
    const findings = this.store.getState().findings ?? { changes: [], updates: [], violations: [] };
    const others = findings.violations.filter((known) => !refusing.some(({ id }) => id === known.id));
    this.store.setState({ findings: { ...findings, violations: [...refusing, ...others] } });
  }
}

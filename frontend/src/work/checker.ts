/** The live check: asks the server what it says of the draft, a moment after the last edit, stale answers dropped. */
import type { StoreApi } from "zustand/vanilla";
import { asProblem } from "../api/problem";
import type { ConflictingElement } from "../api/types";
import { checkDraft } from "../api/workspace";
import type { Declaration, DraftContent, Editor } from "../editor";
import { backoffMs } from "./backoff";
import type { StaleBase, WorkState } from "./workState";

const CHECK_AFTER_MS = 400;

/** The facts of a `save.stale` problem. */
export function staleBase(facts: Record<string, unknown>): StaleBase {
  return {
    head: facts.head as number,
    conflicts: facts.conflicts as ConflictingElement[],
    declarations: facts.declarations as Declaration[],
  };
}

export class Checker {
  private timer: ReturnType<typeof setTimeout> | null = null;
  private controller: AbortController | null = null;
  private failures = 0;

  constructor(
    private readonly task: number,
    private readonly editor: Editor,
    private readonly store: StoreApi<WorkState>,
  ) {}

  /** The map has changed, or the answer at hand is out of date. */
  note(draft: DraftContent, afterMs = CHECK_AFTER_MS): void {
    this.stop();
    this.store.setState({ checking: true });
    this.timer = setTimeout(() => void this.check(draft), afterMs);
  }

  stop(): void {
    if (this.timer !== null) clearTimeout(this.timer);
    this.timer = null;
    this.controller?.abort();
    this.controller = null;
  }

  private async check(draft: DraftContent): Promise<void> {
    const controller = new AbortController();
    this.controller = controller;
    const { savedRevision, savedDeclarations } = this.editor.getState();
    const declarations = draft.declarations ?? [...savedDeclarations];
    const body = { base_revision: savedRevision, edits: draft.edits, declarations };
    try {
      const findings = await checkDraft(this.task, body, controller.signal);
      if (controller.signal.aborted) return;
      this.failures = 0;
      this.store.setState({ findings, checking: false, checkProblem: null, stale: null });
    } catch (error) {
      if (controller.signal.aborted) return;
      const problem = asProblem(error);
      if (problem.passing) {
        this.failures += 1;
        this.note(draft, backoffMs(this.failures));
      } else if (problem.code === "save.stale") {
        this.store.setState({ checking: false, stale: staleBase(problem.facts) });
      } else {
        this.store.setState({ checking: false, checkProblem: problem });
      }
    }
  }
}

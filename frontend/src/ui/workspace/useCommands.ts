import { useCallback, useMemo } from "react";
import type { ElementKey, Violation } from "../../api/types";
import type { PageCommand } from "../../map";
import { retoldWords } from "../../work/canonicalWords";
import type { SaveOutcome, WorkSession } from "../../work/workSession";
import { blockingErrors } from "../../work/workState";
import { counted } from "../parts/words";
import { tell, tellProblem } from "../shell/tell";
import { useSession } from "../useSession";
import { type LeftTab, useWorkspace, type WorkspaceValue, withRevision } from "./context";
import { makeCanonical } from "./makeCanonical";
import { tellDraftIsEmpty } from "./tellDraftIsEmpty";
import { useFindings } from "./useFindings";

/** What keys, buttons and the map have the workspace do. */
export interface Commands {
  readonly save: () => void;
  /** Sends a save of an earlier visit again whose answer nobody saw. */
  readonly saveOnOpen: () => void;
  readonly show: (tab: LeftTab) => void;
  /** Selects an element and turns the map to it. */
  readonly visit: (key: ElementKey) => void;
  readonly applyFix: (violation: Violation, fix: number) => void;
  readonly makeCanonical: () => void;
  readonly run: (command: PageCommand) => void;
}

export function useCommands(): Commands {
  const value = useWorkspace();
  const { account } = useSession();
  const { findings } = useFindings();
  const me = useMemo(() => ({ id: account.id, name: account.name }), [account]);

  const save = useCallback((onOpen: boolean) => saveAndTell(value, me, onOpen), [value, me]);
  const saveNow = useCallback(() => save(false), [save]);
  const saveOnOpen = useCallback(() => {
    if (value.work?.hasPendingSave === true) save(true);
  }, [save, value.work]);

  return useMemo(() => {
    const { editor, screen, mapRef, work } = value;
    const violations = findings?.violations.filter((violation) => !violation.inherited) ?? [];
    const show = (tab: LeftTab) => screen.setState({ tab, leftShown: true });
    const visit = (key: ElementKey) => {
      editor.actions.select(key);
      mapRef.current?.fitElement(key);
    };
    /** The violations' elements while editing, the changes while reviewing. */
    const stops: ElementKey[] =
      work === null
        ? (findings?.changes ?? [])
        : violations.flatMap(({ kind, elements }) => elements.slice(0, 1).map((id) => ({ kind, id })));
    const nextIssue = () => {
      const selected = editor.getState().selection;
      const at = stops.findIndex(({ kind, id }) => kind === selected?.kind && id === selected.id);
      const next = stops[(at + 1) % Math.max(1, stops.length)];
      if (next === undefined) {
        tell(work === null ? "Nothing was changed." : "There is no issue.");
        return;
      }
      show(work === null ? "changes" : "issues");
      visit({ kind: next.kind, id: next.id });
    };
    const applyFix = (violation: Violation, fix: number) => {
      const offered = violation.fixes[fix];
      if (offered === undefined) return;
      if (offered.declarations && work !== null && !isUpToDate(work)) {
        tell("The issues are older than your last edit. Apply this once they are checked again.");
        return;
      }
      void editor.actions.applyFix(offered.edits, offered.title, offered.declarations ?? undefined);
    };
    const canonicalise = () => {
      if (work !== null) makeCanonical(value).catch(tellProblem);
    };
    const applyFirstFix = () => {
      const first = violations.find(({ fixes }) => fixes.length > 0);
      if (first !== undefined && work !== null) applyFix(first, 0);
    };
    const stepFrame = (by: number) =>
      screen.setState(({ frame }) => ({ frame: Math.max(0, (frame ?? -by) + by) }));
    const run = (command: PageCommand) => {
      if (command.name === "flicker") screen.setState({ flicker: command.held });
      else if (command.name === "save") saveNow();
      else if (command.name === "help") screen.setState({ keysShown: true });
      else if (command.name === "find") show("find");
      else if (command.name === "next_issue") nextIssue();
      else if (command.name === "apply_fix") applyFirstFix();
      else if (command.name === "canonical") canonicalise();
      else stepFrame(command.name === "next_frame" ? 1 : -1);
    };
    return { save: saveNow, saveOnOpen, show, visit, applyFix, makeCanonical: canonicalise, run };
  }, [value, findings, saveNow, saveOnOpen]);
}

/** Whether the findings are of the draft as it stands: a fix of declarations carries all of them. */
function isUpToDate({ store }: WorkSession): boolean {
  const { checking, checkProblem, stale } = store.getState();
  return !checking && checkProblem === null && stale === null;
}

function saveAndTell(value: WorkspaceValue, me: { id: number; name: string }, onOpen: boolean): void {
  const { work, screen } = value;
  if (work === null) return;
  const { findings, stale } = work.store.getState();
  if (!onOpen && stale !== null) screen.setState({ staleShown: true });
  else if (!onOpen && blockingErrors(findings) > 0) screen.setState({ tab: "issues", leftShown: true });
  else work.save().then((outcome) => tellOutcome(outcome, value, me), tellProblem);
}

function tellOutcome(
  outcome: SaveOutcome,
  { screen, work, reopen }: WorkspaceValue,
  me: { id: number; name: string },
): void {
  switch (outcome.kind) {
    case "nothing":
      return;
    case "saved": {
      screen.setState((state) => withRevision(state, outcome.saved, me));
      const { revision, restored } = outcome.saved;
      const below =
        restored.length === 0 ? "" : ` ${counted(restored.length, "edit")} below 5 cm went back to the base.`;
      tell(`Saved as revision ${revision}.${below} ${retoldWords(outcome.saved)}`.trim());
      return;
    }
    case "stale":
      screen.setState({ staleShown: true });
      return;
    case "violations":
      screen.setState({ tab: "issues", leftShown: true });
      return;
    case "failed":
      if (outcome.problem.code === "save.empty" && work !== null)
        tellDraftIsEmpty(outcome.problem, () => void work.discard().then(reopen, tellProblem));
      else tellProblem(outcome.problem);
  }
}

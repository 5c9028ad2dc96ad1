import { ago, counted } from "../ui/parts/words";
import type { WorkState } from "./workState";

export type SavingTone = "quiet" | "unsaved" | "trouble";

export interface SavingWords {
  text: string;
  tone: SavingTone;
}

/** Where the work is, in words; always in the header's view. */
export function savingWords(
  state: Pick<WorkState, "edits" | "revision" | "keeping" | "saving">,
  now: number,
): SavingWords {
  if (state.saving === "sending") return { text: "saving…", tone: "unsaved" };
  if (state.saving === "waiting") {
    return {
      text: "the server does not answer the save · trying again, kept on this computer",
      tone: "trouble",
    };
  }
  if (state.edits === 0) {
    return {
      text: state.revision === 0 ? "no changes yet" : `all saved · revision ${state.revision}`,
      tone: "quiet",
    };
  }
  const changes = `${counted(state.edits, "change")} since revision ${state.revision}`;
  const { keeping } = state;
  switch (keeping.where) {
    case "nothing":
    case "computer":
      return { text: `${changes} · kept on this computer`, tone: "unsaved" };
    case "offline":
      return { text: `${changes} · offline: kept on this computer`, tone: "trouble" };
    case "refused":
      return { text: `${changes} · kept on this computer only: ${keeping.problem.message}`, tone: "trouble" };
    case "server":
      return { text: `${changes} · draft kept ${ago(keeping.at, now)}`, tone: "unsaved" };
    case "nowhere":
      return { text: `${changes} · not kept: ${keeping.problem.message}`, tone: "trouble" };
  }
}

import type { ReactNode } from "react";
import type { TaskState } from "../../api/types";
import classes from "./parts.module.css";
import { STATE_WORDS } from "./words";

export type Tone = "plain" | "ok" | "error" | "warning" | "accent";

export function Badge({ tone = "plain", children }: { tone?: Tone; children: ReactNode }) {
  return (
    <span className={classes.badge} data-tone={tone}>
      {children}
    </span>
  );
}

const STATE_TONES: Record<TaskState, Tone> = {
  draft: "plain",
  submitted: "accent",
  in_review: "accent",
  changes_requested: "warning",
  accepted: "ok",
};

export function StateBadge({ state }: { state: TaskState }) {
  return <Badge tone={STATE_TONES[state]}>{STATE_WORDS[state]}</Badge>;
}

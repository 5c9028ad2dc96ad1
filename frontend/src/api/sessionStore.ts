import { createStore } from "zustand/vanilla";
import type { Session } from "./types";

interface SessionState {
  /** undefined: not asked yet; null: nobody is signed in. */
  session: Session | null | undefined;
  /** Whether the server runs with the demo's sign-ins. */
  demo: boolean;
  /** Set while the sign-in dialog stands over a page; answering it lets the waiting requests go on. */
  asking: boolean;
}

export const sessionStore = createStore<SessionState>(() => ({
  session: undefined,
  demo: false,
  asking: false,
}));

let waiting: ((session: Session | null) => void)[] = [];

/** Opens the sign-in dialog over the page (once for all who wait); null: it was closed without signing in. */
export function signInAgain(): Promise<Session | null> {
  sessionStore.setState({ asking: true });
  return new Promise((resolve) => waiting.push(resolve));
}

/** The dialog's answer. */
export function answerSignIn(session: Session | null): void {
  sessionStore.setState(session === null ? { asking: false } : { asking: false, session });
  const answered = waiting;
  waiting = [];
  for (const resolve of answered) resolve(session);
}

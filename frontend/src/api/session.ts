import { ask, attempt, client } from "./client";
import { Problem } from "./problem";
import { sessionStore } from "./sessionStore";
import type { Session } from "./types";

/** Asks who is signed in; null: nobody. */
export async function loadSession(): Promise<Session | null> {
  try {
    const session: Session = await attempt(() => client.GET("/api/v1/session"));
    sessionStore.setState({ session, demo: session.demo });
    return session;
  } catch (error) {
    if (!(error instanceof Problem) || error.status !== 401) throw error;
    sessionStore.setState({ session: null, demo: error.facts.demo === true });
    return null;
  }
}

export const signIn = (name: string, password: string): Promise<Session> =>
  attempt(() => client.POST("/api/v1/session", { body: { name, password } }));

export async function signOut(): Promise<void> {
  try {
    await attempt<unknown>(() => client.DELETE("/api/v1/session"));
  } catch (error) {
    if (!(error instanceof Problem) || error.status !== 401) throw error;
  }
  sessionStore.setState({ session: null });
}

export const changePassword = (current: string, next: string): Promise<unknown> =>
  ask(() => client.PUT("/api/v1/session/password", { body: { current, new: next } }));

import createClient from "openapi-fetch";
import type { Readable } from "openapi-typescript-helpers";
import { Problem, problemFrom, unreachable } from "./problem";
import type { paths } from "./schema.gen";
import { sessionStore, signInAgain } from "./sessionStore";
import type { Session } from "./types";

const UNSAFE = new Set(["POST", "PUT", "PATCH", "DELETE"]);

export const client = createClient<paths>({
  baseUrl: globalThis.location.origin,
  fetch: (request: Request) => globalThis.fetch(request),
});

client.use({
  onRequest({ request }) {
    const token = sessionStore.getState().session?.csrf_token;
    if (token !== undefined && UNSAFE.has(request.method)) request.headers.set("X-CSRF-Token", token);
    return request;
  },
});

/** What openapi-fetch answers; its `Readable` forgets the lengths of tuples, so the data's type is the caller's. */
interface Answer<Data> {
  data?: Readable<Data> | undefined;
  error?: unknown;
  response: Response;
}

/** One attempt: the data, or a Problem thrown. An abort passes through as it is. */
export async function attempt<Data>(request: () => Promise<Answer<NoInfer<Data>>>): Promise<Data> {
  let answer: Answer<Data>;
  try {
    answer = await request();
  } catch (error) {
    if (error instanceof DOMException && error.name === "AbortError") throw error;
    if (error instanceof TypeError) throw unreachable();
    throw error;
  }
  if (!answer.response.ok) throw problemFrom(answer.response, answer.error);
  return answer.data as Data;
}

/**
 * A request as the app makes it: when the session has ended, the user signs in again in place and the request is
 * repeated, so that nothing is lost. Throws the Problem when they do not, or when somebody else signs in.
 */
export async function ask<Data>(request: () => Promise<Answer<NoInfer<Data>>>): Promise<Data> {
  const before = sessionStore.getState().session?.account.id;
  try {
    return await attempt<Data>(request);
  } catch (error) {
    const session = await renewedSession(error);
    if (session === null) throw error;
    if (before !== undefined && session.account.id !== before) {
      throw new Problem(
        403,
        "session.other_account",
        `This was started by another account; you are now ${session.account.name}.`,
        "Sign in with the account that started it. Its work is kept on this computer.",
      );
    }
    return await attempt<Data>(request);
  }
}

/** A session with which the failed request may succeed; null: the failure has another reason, or nobody signed in. */
async function renewedSession(error: unknown): Promise<Session | null> {
  if (!(error instanceof Problem)) return null;
  if (error.status === 401) return await signInAgain();
  if (error.code !== "session.csrf") return null;
  // Another tab signed in anew: this one has the new cookie, but the old session's CSRF token.
  const session = await attempt<Session>(() => client.GET("/api/v1/session"));
  sessionStore.setState({ session });
  return session;
}

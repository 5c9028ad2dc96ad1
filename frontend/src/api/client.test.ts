import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { answerSignIn, sessionStore } from "./sessionStore";
import { listTokens, revokeToken } from "./tokens";
import type { Session } from "./types";

const session = (id: number, csrf_token: string): Session => ({
  account: { id, name: `person ${id}`, role: "annotator", created_at: "", disabled_at: null },
  csrf_token,
  demo: false,
});
const answer = (status: number, body: unknown) =>
  new Response(status === 204 ? null : JSON.stringify(body), {
    status,
    headers: { "Content-Type": "application/json" },
  });
const signedOut = () =>
  answer(401, { code: "session.none", message: "You are signed out.", mend: "Sign in." });

/** The server: each request is noted and gets the next answer. */
function serverAnswers(...answers: (() => Response | Promise<Response>)[]) {
  const requests: Request[] = [];
  vi.stubGlobal("fetch", (request: Request) => {
    requests.push(request);
    const next = answers.shift();
    if (next === undefined) throw new Error(`unexpected ${request.method} ${request.url}`);
    return Promise.resolve(next());
  });
  return requests;
}

describe("requests", () => {
  beforeEach(() => sessionStore.setState({ session: session(1, "first"), asking: false }));
  afterEach(() => vi.unstubAllGlobals());

  it("prove with the session's token that our page sent what changes something", async () => {
    const requests = serverAnswers(
      () => answer(200, []),
      () => answer(204, null),
    );
    await listTokens();
    await revokeToken(4);
    expect(requests.map((request) => request.headers.get("X-CSRF-Token"))).toEqual([null, "first"]);
  });

  it("wait for signing in again and are then repeated with the new session", async () => {
    const requests = serverAnswers(signedOut, () => answer(204, null));
    const revoked = revokeToken(4);
    await vi.waitFor(() => expect(sessionStore.getState().asking).toBe(true));
    answerSignIn(session(1, "second"));
    await revoked;
    expect(requests.at(-1)?.headers.get("X-CSRF-Token")).toBe("second");
  });

  it("fail with the server's words when the sign-in is dismissed", async () => {
    serverAnswers(signedOut);
    const tokens = listTokens();
    await vi.waitFor(() => expect(sessionStore.getState().asking).toBe(true));
    answerSignIn(null);
    await expect(tokens).rejects.toMatchObject({ message: "You are signed out.", mend: "Sign in." });
  });

  it("are not repeated in the name of somebody else", async () => {
    const requests = serverAnswers(signedOut);
    const revoked = revokeToken(4);
    await vi.waitFor(() => expect(sessionStore.getState().asking).toBe(true));
    answerSignIn(session(2, "other"));
    await expect(revoked).rejects.toMatchObject({ code: "session.other_account" });
    expect(requests).toHaveLength(1);
  });

  it("learn the new token when another tab signed in anew", async () => {
    const csrf = () => answer(403, { code: "session.csrf", message: "The header is missing.", mend: "" });
    const requests = serverAnswers(
      csrf,
      () => answer(200, session(1, "newer")),
      () => answer(204, null),
    );
    await revokeToken(4);
    expect(requests.at(-1)?.headers.get("X-CSRF-Token")).toBe("newer");
  });

  it("say that the server was not reached, and that this may pass", async () => {
    serverAnswers(() => Promise.reject(new TypeError("Failed to fetch")));
    await expect(listTokens()).rejects.toMatchObject({ code: "network.unreachable", passing: true });
  });

  it("explain an answer that is no explanation, such as a proxy's page", async () => {
    serverAnswers(() => new Response("<h1>Bad Gateway</h1>", { status: 502 }));
    await expect(listTokens()).rejects.toMatchObject({
      message: "The server answered with status 502 and no explanation.",
      passing: true,
    });
  });
});

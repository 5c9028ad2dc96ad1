/** Every failure of a request as one value: what is wrong, what mends it, and the server's facts. */
export class Problem extends Error {
  override readonly name = "Problem";

  constructor(
    /** HTTP status; 0: the server was not reached. */
    readonly status: number,
    readonly code: string,
    message: string,
    readonly mend: string,
    readonly facts: Record<string, unknown> = {},
    readonly requestId = "",
  ) {
    super(message);
  }

  /** Whether the same request may succeed later without anybody changing anything. */
  get passing(): boolean {
    return this.status === 0 || this.status === 429 || this.status >= 500;
  }
}

export const unreachable = () =>
  new Problem(
    0,
    "network.unreachable",
    "The server does not answer.",
    "Check the connection, then try again.",
  );

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}

const text = (value: unknown) => (typeof value === "string" ? value : "");

/** Reads an error's body; anything that is not the API's own error (a proxy's page, say) is told by its status. */
export function problemFrom(response: Response, body: unknown): Problem {
  const requestId = response.headers.get("X-Request-ID") ?? "";
  if (!isRecord(body) || typeof body.message !== "string") {
    return new Problem(
      response.status,
      "server.unreadable",
      `The server answered with status ${response.status} and no explanation.`,
      "Try again; if it stays, tell the person who runs this server.",
      {},
      requestId,
    );
  }
  return new Problem(
    response.status,
    text(body.code),
    body.message,
    text(body.mend),
    isRecord(body.facts) ? body.facts : {},
    text(body.request_id) || requestId,
  );
}

/** Any thrown value as a Problem, for showing it. */
export function asProblem(error: unknown): Problem {
  if (error instanceof Problem) return error;
  const message = error instanceof Error ? error.message : String(error);
  return new Problem(0, "page.failed", "This page stumbled over an error of its own.", "Reload the page.", {
    message,
  });
}

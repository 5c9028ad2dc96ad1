const FIRST_MS = 1_000;
const LONGEST_MS = 30_000;

/** How long to wait before trying again after so many failures: 1, 2, 4 … 30 s. */
export const backoffMs = (failures: number): number =>
  Math.min(LONGEST_MS, FIRST_MS * 2 ** Math.max(0, failures - 1));

/** Waits, but no longer than until the browser is online again; throws when given up. */
export function pause(milliseconds: number, signal: AbortSignal): Promise<void> {
  return new Promise((resolve, reject) => {
    const end = () => {
      clearTimeout(timer);
      globalThis.removeEventListener("online", go);
      signal.removeEventListener("abort", stop);
    };
    const go = () => {
      end();
      resolve();
    };
    const stop = () => {
      end();
      reject(new DOMException("given up", "AbortError"));
    };
    const timer = setTimeout(go, milliseconds);
    globalThis.addEventListener("online", go);
    signal.addEventListener("abort", stop);
    if (signal.aborted) stop();
  });
}

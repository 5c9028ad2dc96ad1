/** One tab of a browser edits a task at a time; another may take it over. */

export interface TabLock {
  release(): void;
}

/** A tab that just let go, or the page before a reload, may hold the lock for a moment longer. */
const PATIENCE_MS = 700;

/**
 * Claims the task for this tab. Resolves to null when another tab has it, unless `steal`. `onLost` is called when
 * another tab takes it over. Browsers without the Web Locks API (plain http but for loopback) always get it; the
 * versions of the server's draft then keep tabs from overwriting each other.
 */
export function claimTask(name: string, steal: boolean, onLost: () => void): Promise<TabLock | null> {
  const locks = (navigator as { locks?: LockManager }).locks;
  if (locks === undefined) return Promise.resolve({ release() {} });
  return new Promise((resolve) => {
    let release = () => {};
    let granted = false;
    const held = new Promise<void>((end) => {
      release = end;
    });
    const options = steal ? { steal } : { signal: AbortSignal.timeout(PATIENCE_MS) };
    locks
      .request(name, options, () => {
        granted = true;
        resolve({ release });
        return held;
      })
      // A lock that is held fails only when another tab steals it; one that is waited for, when patience ends.
      .catch(() => (granted ? onLost() : resolve(null)));
  });
}

import { useCallback, useEffect, useState } from "react";
import { workKey } from "../../work/browserStore";
import { type Opened, openTask } from "../../work/openTask";
import { claimTask } from "../../work/tabLock";
import { useSession } from "../useSession";

export type OpenState =
  | { status: "opening" }
  | { status: "failed"; error: unknown }
  /** Another tab of this browser has the task. */
  | { status: "elsewhere" }
  | { status: "open"; opened: Opened };

interface Request {
  /** Counts the openings; each reads the task anew. */
  serial: number;
  decision: "local" | "server" | null;
  takeOver: boolean;
}

/** Opens a task for editing in this tab, and opens it anew on demand. */
export function useOpenTask(task: number) {
  const account = useSession().account.id;
  const [request, setRequest] = useState<Request>({ serial: 0, decision: null, takeOver: false });
  const [state, setState] = useState<OpenState>({ status: "opening" });

  useEffect(() => {
    const key = { account, task };
    let gone = false;
    let opened: Opened | null = null;
    let release = () => {};
    const end = () => {
      if (opened?.kind === "editing") opened.work.end();
      release();
    };
    const open = async () => {
      const lock = await claimTask(`lanewright:${workKey(key)}`, request.takeOver, () => {
        end();
        if (!gone) setState({ status: "elsewhere" });
      });
      if (gone) return lock?.release();
      if (lock === null) return setState({ status: "elsewhere" });
      release = () => lock.release();
      opened = await openTask(key, request.decision);
      if (gone) end();
      else setState({ status: "open", opened });
    };
    setState({ status: "opening" });
    open().catch((error: unknown) => {
      release();
      if (!gone) setState({ status: "failed", error });
    });
    return () => {
      gone = true;
      end();
    };
  }, [account, task, request]);

  const again = useCallback(
    (change: Partial<Omit<Request, "serial">> = {}) =>
      setRequest(({ serial }) => ({ serial: serial + 1, decision: null, takeOver: false, ...change })),
    [],
  );
  return { state, again };
}

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
    let over = false;
    const isOver = () => over;
    let opened: Opened | null = null;
    let release = () => {};
    const end = () => {
      if (opened?.kind === "editing") opened.work.end();
      release();
    };
    const open = async () => {
      const lock = await claimTask(`lanewright:${workKey(key)}`, request.takeOver, () => {
        end();
        if (!isOver()) setState({ status: "elsewhere" });
      });
      if (isOver()) {
        lock?.release();
        return;
      }
      if (lock === null) {
        setState({ status: "elsewhere" });
        return;
      }
      release = () => lock.release();
      opened = await openTask(key, request.decision);
      if (isOver()) end();
      else setState({ status: "open", opened });
    };
    open().catch((error: unknown) => {
      release();
      if (!isOver()) setState({ status: "failed", error });
    });
    return () => {
      over = true;
      end();
    };
  }, [account, task, request]);

  const again = useCallback((change: Partial<Omit<Request, "serial">> = {}) => {
    setState({ status: "opening" });
    setRequest(({ serial }) => ({ serial: serial + 1, decision: null, takeOver: false, ...change }));
  }, []);
  return { state, again };
}

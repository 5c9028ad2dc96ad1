import { Button } from "@mantine/core";
import { useQueryClient } from "@tanstack/react-query";
import { useState } from "react";
import { writeRemarks } from "../../work/browserStore";
import { usePressAgain } from "../parts/usePressAgain";
import { SendBackDialog } from "../review/SendBackDialog";
import { accept, mayJudge } from "../review/steps";
import { tell, tellProblem } from "../shell/tell";
import { useSession } from "../useSession";
import { useScreen, useWorkspace } from "./context";
import { ReopenDialog } from "./ReopenDialog";
import { useRemarks } from "./useRemarks";
import { useReviewKeys } from "./useReviewKeys";

/** What a reviewer, or an admin of an accepted task, may do with the revision on the screen. */
export function Decisions() {
  const { workspace, reopen } = useWorkspace();
  const task = useScreen((state) => state.task);
  const account = useSession().account.id;
  const { remarks } = useRemarks();
  const queryClient = useQueryClient();
  const [busy, setBusy] = useState(false);
  const [dialog, setDialog] = useState<"send_back" | "reopen" | null>(null);
  const newest = workspace.revision === task.head;
  const judging = mayJudge(task) && newest;

  const decided = (words: string) => {
    setDialog(null);
    tell(`Task ${task.id} ${words}.`);
    void writeRemarks({ account, task: task.id }, []);
    void queryClient.invalidateQueries({ queryKey: ["tasks"] });
    reopen();
  };
  const acceptIt = () => {
    if (busy) return;
    setBusy(true);
    accept(task, workspace.revision)
      .then(() => decided("accepted"), tellProblem)
      .finally(() => setBusy(false));
  };
  const pressAccept = usePressAgain(
    () => tell(`Press G again to accept revision ${workspace.revision}.`),
    acceptIt,
  );
  useReviewKeys(
    judging && dialog === null,
    () => pressAccept(`${task.id} ${workspace.revision}`),
    () => setDialog("send_back"),
  );
  return (
    <>
      {judging && (
        <>
          <Button variant="light" color="green" rightSection={<kbd>G</kbd>} loading={busy} onClick={acceptIt}>
            Accept
          </Button>
          <Button
            variant="light"
            color="red"
            rightSection={<kbd>B</kbd>}
            onClick={() => setDialog("send_back")}
          >
            Send back{remarks.length > 0 ? ` (${remarks.length})` : ""}
          </Button>
        </>
      )}
      {task.actions.includes("reopen") && (
        <Button variant="default" onClick={() => setDialog("reopen")}>
          Reopen
        </Button>
      )}
      {dialog === "send_back" && (
        <SendBackDialog
          task={task}
          revision={workspace.revision}
          remarks={remarks}
          onClose={() => setDialog(null)}
          onDone={() => decided("sent back")}
        />
      )}
      {dialog === "reopen" && (
        <ReopenDialog task={task} onClose={() => setDialog(null)} onDone={() => decided("reopened")} />
      )}
    </>
  );
}

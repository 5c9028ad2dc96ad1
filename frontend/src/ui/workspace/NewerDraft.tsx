import { Button, Group, Modal, Stack } from "@mantine/core";
import { parkDraft } from "../../work/browserStore";
import { countChanges } from "../../work/workState";
import { useNow } from "../parts/useNow";
import { ago, counted } from "../parts/words";
import { tellProblem } from "../shell/tell";
import { useSession } from "../useSession";
import { useEditor, useWorkspace } from "./context";
import { useWork } from "./useFindings";

/** Another computer kept a newer draft while this one was open. */
export function NewerDraft() {
  const { work, workspace, reopen } = useWorkspace();
  const key = { account: useSession().account.id, task: workspace.task.id };
  const newer = useWork((state) => state.newerDraft);
  const edits = useWork((state) => state.edits);
  const standing = useEditor((state) => state.savedDeclarations);
  const now = useNow();
  if (work === null || newer === null) return null;

  const keepMine = () => {
    const reason = "kept by another window or computer";
    const { base_revision: baseRevision, edits: theirs, declarations } = newer;
    parkDraft(key, { reason, baseRevision, edits: theirs, declarations })
      .then(() => work.keepMine(newer))
      .catch(tellProblem);
  };
  return (
    <Modal
      opened
      onClose={() => work.store.setState({ newerDraft: null })}
      title="This task was edited elsewhere meanwhile"
    >
      <Stack gap={12}>
        <p>
          Another window or computer of yours kept {counted(countChanges(newer, standing), "change")}{" "}
          {ago(newer.kept_at, now)}; here are {edits}. The draft that you do not choose is set aside under
          History.
        </p>
        <Group justify="flex-end" gap={8}>
          <Button variant="default" onClick={reopen}>
            Compare and choose
          </Button>
          <Button onClick={keepMine} data-autofocus>
            Keep what is here
          </Button>
        </Group>
      </Stack>
    </Modal>
  );
}

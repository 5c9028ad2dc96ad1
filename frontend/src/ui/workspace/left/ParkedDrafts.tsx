import { Button } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { parkedDrafts, removeParked } from "../../../work/browserStore";
import { countChanges } from "../../../work/workState";
import { useNow } from "../../parts/useNow";
import { ago, counted } from "../../parts/words";
import { useSession } from "../../useSession";
import { useWorkspace } from "../context";
import { downloadDraft } from "../downloadDraft";
import classes from "./left.module.css";

/** Drafts of this task that were set aside; they stay until the user removes them. */
export function ParkedDrafts() {
  const { workspace } = useWorkspace();
  const key = { account: useSession().account.id, task: workspace.task.id };
  const now = useNow();
  const parked = useQuery({ queryKey: ["parked", key], queryFn: () => parkedDrafts(key), staleTime: 0 });
  return (parked.data ?? []).map(({ id, draft }) => (
    <div key={id} className={classes.parked}>
      <span>
        Draft set aside {ago(draft.parkedAt, now)}:{" "}
        {counted(countChanges(draft, workspace.declarations), "change")} since revision {draft.baseRevision},{" "}
        {draft.reason}.
      </span>
      <span className={classes.fixes}>
        <Button variant="default" size="compact-xs" onClick={() => downloadDraft(key.task, draft)}>
          Download
        </Button>
        <Button
          variant="subtle"
          size="compact-xs"
          onClick={() => void removeParked(id).then(() => parked.refetch())}
        >
          Remove
        </Button>
      </span>
    </div>
  ));
}

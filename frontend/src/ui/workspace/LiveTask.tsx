import { Button } from "@mantine/core";
import { Loading } from "../parts/Loading";
import { Banner } from "./Banner";
import { ChooseDraft } from "./ChooseDraft";
import { Leftover } from "./Leftover";
import { OpenElsewhere } from "./OpenElsewhere";
import { OpenFailed } from "./OpenFailed";
import { useOpenTask } from "./useOpenTask";
import { WorkspaceScreen } from "./WorkspaceScreen";

/** A task at its newest revision: to edit, or, where its state or the asker's part in it forbids that, to look at. */
export function LiveTask({ task }: { task: number }) {
  const { state, again } = useOpenTask(task);
  if (state.status === "opening") return <Loading what="the map" />;
  if (state.status === "failed") return <OpenFailed error={state.error} onRetry={() => again()} />;
  if (state.status === "elsewhere") return <OpenElsewhere onTakeOver={() => again({ takeOver: true })} />;
  const { opened } = state;
  if (opened.kind === "choosing") {
    return <ChooseDraft choosing={opened} onChoose={(decision) => again({ decision })} />;
  }
  const screen = { workspace: opened.workspace, editor: opened.editor, reopen: () => again() };
  if (opened.kind === "reading") {
    const { leftover, workspace } = opened;
    return (
      <WorkspaceScreen
        {...screen}
        work={null}
        banner={leftover !== null && <Leftover task={workspace.task} draft={leftover} />}
      />
    );
  }
  return (
    <WorkspaceScreen
      {...screen}
      work={opened.work}
      banner={
        opened.unusable !== null && (
          <Banner tone="warning">
            <span>{opened.unusable} It is set aside under History.</span>
            <Button variant="default" onClick={() => again()}>
              Reload
            </Button>
          </Banner>
        )
      }
    />
  );
}

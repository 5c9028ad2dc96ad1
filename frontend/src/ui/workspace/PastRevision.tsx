import { Button } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useSearchParams } from "wouter";
import { openRevision } from "../../work/openTask";
import { Loading } from "../parts/Loading";
import { Banner } from "./Banner";
import { OpenFailed } from "./OpenFailed";
import { WorkspaceScreen } from "./WorkspaceScreen";

/** A task as it was at one of its revisions, only to look at. */
export function PastRevision({ task, revision }: { task: number; revision: number }) {
  const [, setParameters] = useSearchParams();
  const opened = useQuery({
    queryKey: ["revision", task, revision],
    queryFn: () => openRevision(task, revision),
    staleTime: Number.POSITIVE_INFINITY,
    gcTime: 0,
  });
  const back = () =>
    setParameters((before) => {
      const next = new URLSearchParams(before);
      next.delete("revision");
      return next;
    });
  if (opened.isError) return <OpenFailed error={opened.error} onRetry={() => void opened.refetch()} />;
  if (opened.data === undefined) return <Loading what={`revision ${revision}`} />;
  const { workspace, editor } = opened.data;
  return (
    <WorkspaceScreen
      workspace={workspace}
      editor={editor}
      work={null}
      reopen={() => void opened.refetch()}
      banner={
        <Banner tone="plain">
          <span>
            Revision {revision} of {workspace.task.head}, only to look at.
          </span>
          <Button variant="default" onClick={back}>
            Back to the newest
          </Button>
        </Banner>
      }
    />
  );
}

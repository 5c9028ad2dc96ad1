import { useComputedColorScheme } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useMemo, useState } from "react";
import type { Findings, Task } from "../../api/types";
import { type KeyText, keyText } from "../../editor";
import { MapView } from "../../map";
import { openRevision } from "../../work/openTask";
import { Loading } from "../parts/Loading";
import { ProblemNotice } from "../parts/ProblemNotice";
import { changedBounds } from "./changedBounds";

interface DifferencePreviewProperties {
  task: Task;
  findings: Findings | undefined;
}

/** What the task changed, on a small map. */
export function DifferencePreview({ task, findings }: DifferencePreviewProperties) {
  const theme = useComputedColorScheme("dark");
  const [unavailable, setUnavailable] = useState<string | null>(null);
  const opened = useQuery({
    queryKey: ["preview", task.id, task.head],
    queryFn: () => openRevision(task.id, task.head),
    staleTime: Number.POSITIVE_INFINITY,
    gcTime: 60_000,
  });
  const categories = useMemo(
    () =>
      findings === undefined
        ? null
        : new Map<KeyText, readonly string[]>(
            findings.changes.map((change) => [keyText(change), change.categories]),
          ),
    [findings],
  );
  const workspace = opened.data?.workspace;
  const bounds = useMemo(() => (workspace === undefined ? null : changedBounds(workspace)), [workspace]);
  if (opened.isError) return <ProblemNotice error={opened.error} onRetry={() => void opened.refetch()} />;
  if (opened.data === undefined || workspace === undefined) return <Loading what="the map" />;
  if (unavailable !== null) return <p className="second">{unavailable}</p>;
  return (
    <MapView
      editor={opened.data.editor}
      frame={workspace.frame}
      bounds={bounds ?? workspace.bounds}
      drivableAreas={workspace.drivable_areas}
      direction={task.direction}
      view="difference"
      categories={categories}
      theme={theme}
      onUnavailable={setUnavailable}
    />
  );
}

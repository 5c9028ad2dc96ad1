import { useQuery } from "@tanstack/react-query";
import { useStore } from "zustand";
import { createStore } from "zustand/vanilla";
import { getFindings } from "../../api/tasks";
import type { Findings } from "../../api/types";
import type { WorkState } from "../../work/workState";
import { useWorkspace } from "./context";

/** Stands in where nothing is edited. */
const AT_REST = createStore<WorkState>(() => ({
  edits: 0,
  revision: 0,
  keeping: { where: "nothing" },
  saving: "no",
  findings: null,
  checking: false,
  checkProblem: null,
  stale: null,
  newerDraft: null,
  elsewhere: false,
}));

export function useWork<Part>(select: (state: WorkState) => Part): Part {
  const { work } = useWorkspace();
  return useStore(work?.store ?? AT_REST, select);
}

/** What the server says of the map on the screen: of the draft while editing, of the revision while reading. */
export function useFindings(): { findings: Findings | null; checking: boolean; problem: Error | null } {
  const { work, workspace } = useWorkspace();
  const live = useWork((state) => state.findings);
  const checking = useWork((state) => state.checking);
  const checkProblem = useWork((state) => state.checkProblem);
  const stored = useQuery({
    queryKey: ["findings", workspace.task.id, workspace.revision],
    queryFn: () => getFindings(workspace.task.id, workspace.revision),
    staleTime: Number.POSITIVE_INFINITY,
    enabled: work === null,
  });
  if (work !== null) return { findings: live, checking, problem: checkProblem };
  return { findings: stored.data ?? null, checking: stored.isPending, problem: stored.error };
}

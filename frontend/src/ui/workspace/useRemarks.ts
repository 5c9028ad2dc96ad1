import { useQuery, useQueryClient } from "@tanstack/react-query";
import type { ElementKey, Remark } from "../../api/types";
import { readRemarks, writeRemarks } from "../../work/browserStore";
import { useSession } from "../useSession";
import { useWorkspace } from "./context";

/** The reviewer's remarks on elements until they are sent; kept on this computer. */
export function useRemarks() {
  const { workspace } = useWorkspace();
  const account = useSession().account.id;
  const key = { account, task: workspace.task.id };
  const queryKey = ["remarks", account, workspace.task.id];
  const queryClient = useQueryClient();
  const stored = useQuery({ queryKey, queryFn: () => readRemarks(key), staleTime: Number.POSITIVE_INFINITY });
  const remarks = stored.data ?? [];
  /** An empty text takes the remark away. */
  const set = (element: ElementKey, text: string) => {
    const others = remarks.filter((one) => one.kind !== element.kind || one.element_id !== element.id);
    const next: Remark[] =
      text.trim() === "" ? others : [...others, { kind: element.kind, element_id: element.id, text }];
    queryClient.setQueryData(queryKey, next);
    void writeRemarks(key, next);
  };
  return { remarks, set };
}

import { useSearchParams } from "wouter";
import { NotFoundPage } from "../pages/NotFoundPage";
import { LiveTask } from "./LiveTask";
import { PastRevision } from "./PastRevision";

/** The workspace by its address: /tasks/12?element=lane_segment:123&revision=4. */
export function TaskPage({ task }: { task: string }) {
  const [parameters] = useSearchParams();
  const id = Number(task);
  const revision = parameters.get("revision");
  if (!/^\d+$/.test(task) || !Number.isSafeInteger(id) || id < 1) return <NotFoundPage />;
  if (revision !== null && /^\d{1,9}$/.test(revision)) {
    return <PastRevision key={`${id}:${revision}`} task={id} revision={Number(revision)} />;
  }
  return <LiveTask key={id} task={id} />;
}

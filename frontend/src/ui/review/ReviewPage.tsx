import { useHotkeys } from "@mantine/hooks";
import { keepPreviousData, useQuery, useQueryClient } from "@tanstack/react-query";
import { useState } from "react";
import { useLocation } from "wouter";
import { listTasks } from "../../api/tasks";
import type { Task } from "../../api/types";
import { CityAndSplit, SearchField } from "../pages/filters";
import { PageHead } from "../pages/PageHead";
import { Pages } from "../pages/Pages";
import pages from "../pages/pages.module.css";
import { useFilter } from "../pages/useFilter";
import { Loading } from "../parts/Loading";
import { ProblemNotice } from "../parts/ProblemNotice";
import { useNow } from "../parts/useNow";
import { usePressAgain } from "../parts/usePressAgain";
import { duration, shortLogName } from "../parts/words";
import { tell, tellProblem } from "../shell/tell";
import { NothingToReview } from "./NothingToReview";
import { ReviewDetail } from "./ReviewDetail";
import { ReviewTable } from "./ReviewTable";
import classes from "./review.module.css";
import { SendBackDialog } from "./SendBackDialog";
import { accept } from "./steps";

const PAGE_SIZE = 50;

export function ReviewPage() {
  const filter = useFilter();
  const now = useNow();
  const [, go] = useLocation();
  const queryClient = useQueryClient();
  const [sendingBack, setSendingBack] = useState<Task | null>(null);
  const [busy, setBusy] = useState(false);
  const query = {
    reviewable: true,
    sort: "waiting" as const,
    q: filter.value("q"),
    page: filter.page,
    page_size: PAGE_SIZE,
    ...(filter.value("city") && { city: filter.value("city") }),
    ...(filter.value("split") && { split: filter.value("split") }),
  };
  const queue = useQuery({
    queryKey: ["tasks", query],
    queryFn: () => listTasks(query),
    placeholderData: keepPreviousData,
  });
  const tasks = queue.data?.items ?? [];
  const chosenId = Number(filter.value("task"));
  const index = Math.max(
    0,
    tasks.findIndex((task) => task.id === chosenId),
  );
  const chosen = tasks[index];

  const choose = (task: Task | undefined) =>
    task !== undefined && filter.set({ task: String(task.id), page: filter.value("page") });
  const step = (by: number) => choose(tasks[Math.min(tasks.length - 1, Math.max(0, index + by))]);
  const open = (task: Task | undefined) => task !== undefined && go(`/tasks/${task.id}`);

  /** The judged task leaves the queue; the one after it is next. */
  const judged = (task: Task, words: string) => {
    tell(`Task ${task.id} (${shortLogName(task.log_id)}) ${words}.`);
    choose(tasks[index + 1] ?? tasks[index - 1]);
    void queryClient.invalidateQueries({ queryKey: ["tasks"] });
  };
  const acceptChosen = () => {
    if (chosen === undefined || busy) return;
    setBusy(true);
    accept(chosen, chosen.head)
      .then((task) => judged(task, "accepted"), tellProblem)
      .finally(() => setBusy(false));
  };
  const pressAccept = usePressAgain(() => tell(`Press G again to accept task ${chosen?.id}.`), acceptChosen);
  const acceptByKey = () => chosen !== undefined && pressAccept(`${chosen.id} ${chosen.head}`);
  useHotkeys([
    ["ArrowDown", () => step(1)],
    ["J", () => step(1)],
    ["N", () => step(1)],
    ["ArrowUp", () => step(-1)],
    ["K", () => step(-1)],
    ["Enter", () => open(chosen), { preventDefault: false }],
    ["G", (event) => !event.repeat && sendingBack === null && acceptByKey()],
    ["B", () => chosen !== undefined && setSendingBack(chosen)],
  ]);

  const oldest = tasks[0];
  return (
    <div className={classes.split}>
      <div className={pages.page}>
        <PageHead
          title="Review queue"
          subtitle={
            oldest !== undefined && queue.data !== undefined ? (
              <>
                {queue.data.total} waiting · oldest{" "}
                {duration((now - new Date(oldest.state_since).getTime()) / 1000)} · <kbd>G</kbd> <kbd>G</kbd>{" "}
                accept · <kbd>B</kbd> send back · <kbd>N</kbd> next · <kbd>Enter</kbd> open
              </>
            ) : undefined
          }
        />
        <div className={pages.filters}>
          <SearchField filter={filter} label="Search logs" />
          <CityAndSplit filter={filter} />
        </div>
        {queue.isPending && <Loading what="the review queue" />}
        {queue.isError && <ProblemNotice error={queue.error} onRetry={() => void queue.refetch()} />}
        {queue.data && tasks.length > 0 && (
          <>
            <ReviewTable tasks={tasks} chosen={chosen?.id} onChoose={choose} onOpen={open} />
            <Pages filter={filter} total={queue.data.total} pageSize={PAGE_SIZE} noun="task" />
          </>
        )}
        {queue.data && tasks.length === 0 && (
          <NothingToReview filtered={filter.filtered} onClear={filter.clear} />
        )}
      </div>
      {chosen !== undefined && (
        <ReviewDetail
          key={chosen.id}
          task={chosen}
          busy={busy}
          onAccept={acceptChosen}
          onSendBack={() => setSendingBack(chosen)}
          onOpen={() => open(chosen)}
        />
      )}
      {sendingBack !== null && (
        <SendBackDialog
          task={sendingBack}
          revision={sendingBack.head}
          onClose={() => setSendingBack(null)}
          onDone={(task) => {
            setSendingBack(null);
            judged(task, "sent back");
          }}
        />
      )}
    </div>
  );
}

import { Button } from "@mantine/core";
import { keepPreviousData, useQuery } from "@tanstack/react-query";
import { Link } from "wouter";
import { listTasks } from "../../api/tasks";
import { EmptyState } from "../parts/EmptyState";
import { Loading } from "../parts/Loading";
import { ProblemNotice } from "../parts/ProblemNotice";
import { useRole } from "../useSession";
import { SearchField } from "./filters";
import { PageHead } from "./PageHead";
import { Pages } from "./Pages";
import classes from "./pages.module.css";
import { asStates, StateFilter } from "./StateFilter";
import { TaskTable } from "./TaskTable";
import { useFilter } from "./useFilter";

const PAGE_SIZE = 50;

export function MyTasksPage() {
  const filter = useFilter();
  const query = {
    assignee: "me",
    q: filter.value("q"),
    state: asStates(filter.values("state")),
    page: filter.page,
    page_size: PAGE_SIZE,
  };
  const tasks = useQuery({
    queryKey: ["tasks", query],
    queryFn: () => listTasks(query),
    placeholderData: keepPreviousData,
  });
  return (
    <div className={classes.page}>
      <PageHead title="My tasks" subtitle="What is assigned to you, newest first." />
      <div className={classes.filters}>
        <SearchField filter={filter} label="Search logs" />
      </div>
      {tasks.data && <StateFilter filter={filter} counts={tasks.data.state_counts} />}
      {tasks.isPending && <Loading what="your tasks" />}
      {tasks.isError && <ProblemNotice error={tasks.error} onRetry={() => void tasks.refetch()} />}
      {tasks.data && tasks.data.items.length > 0 && (
        <>
          <TaskTable tasks={tasks.data.items} />
          <Pages filter={filter} total={tasks.data.total} pageSize={PAGE_SIZE} noun="task" />
        </>
      )}
      {tasks.data?.items.length === 0 && <NoTasks filtered={filter.filtered} onClear={filter.clear} />}
    </div>
  );
}

function NoTasks({ filtered, onClear }: { filtered: boolean; onClear: () => void }) {
  const role = useRole();
  if (filtered) {
    return (
      <EmptyState title="No task of yours matches">
        <Button variant="default" onClick={onClear}>
          Clear the filter
        </Button>
      </EmptyState>
    );
  }
  return (
    <EmptyState title="Nothing is assigned to you">
      {role === "annotator" && <p>Ask an admin for a task; it appears here as soon as you have one.</p>}
      {role === "reviewer" && (
        <p>
          Work for you waits in the <Link href="/review">review queue</Link>.
        </p>
      )}
      {role === "admin" && (
        <p>
          Create tasks from the <Link href="/logs">logs</Link>, or assign existing ones under{" "}
          <Link href="/tasks">all tasks</Link>.
        </p>
      )}
    </EmptyState>
  );
}

import { Button } from "@mantine/core";
import { keepPreviousData, useQuery, useQueryClient } from "@tanstack/react-query";
import { useState } from "react";
import { Link } from "wouter";
import { listPeople } from "../../api/accounts";
import { listTasks } from "../../api/tasks";
import { EmptyState } from "../parts/EmptyState";
import { Loading } from "../parts/Loading";
import { ProblemNotice } from "../parts/ProblemNotice";
import { counted } from "../parts/words";
import { useRole } from "../useSession";
import { AssignDialog } from "./AssignDialog";
import { Choice, CityAndSplit, SearchField } from "./filters";
import { PageHead } from "./PageHead";
import { Pages } from "./Pages";
import classes from "./pages.module.css";
import { asStates, StateFilter } from "./StateFilter";
import { TaskTable } from "./TaskTable";
import { useFilter } from "./useFilter";

const PAGE_SIZE = 50;
const SORTS = [
  { value: "newest", label: "Newest first" },
  { value: "waiting", label: "Longest waiting" },
  { value: "log", label: "By log" },
];
type Sort = "newest" | "waiting" | "log";

export function AllTasksPage() {
  const filter = useFilter();
  const admin = useRole() === "admin";
  const queryClient = useQueryClient();
  const [ticked, setTicked] = useState<ReadonlySet<number>>(new Set());
  const [assigning, setAssigning] = useState(false);
  const people = useQuery({ queryKey: ["people"], queryFn: listPeople });
  const query = {
    q: filter.value("q"),
    state: asStates(filter.values("state")),
    assignee: filter.value("assignee"),
    sort: (SORTS.find((sort) => sort.value === filter.value("sort"))?.value ?? "newest") as Sort,
    page: filter.page,
    page_size: PAGE_SIZE,
    ...(filter.value("city") && { city: filter.value("city") }),
    ...(filter.value("split") && { split: filter.value("split") }),
  };
  const tasks = useQuery({
    queryKey: ["tasks", query],
    queryFn: () => listTasks(query),
    placeholderData: keepPreviousData,
  });
  const assignees = [
    { value: "nobody", label: "Nobody" },
    ...(people.data ?? []).map((person) => ({ value: String(person.id), label: person.name })),
  ];
  const assigned = () => {
    setAssigning(false);
    setTicked(new Set());
    void queryClient.invalidateQueries({ queryKey: ["tasks"] });
  };
  return (
    <div className={classes.page}>
      <PageHead title="All tasks" />
      <div className={classes.filters}>
        <SearchField filter={filter} label="Search logs" />
        <CityAndSplit filter={filter} />
        <Choice filter={filter} name="assignee" label="Any assignee" options={assignees} width={150} />
        <Choice filter={filter} name="sort" label="Newest first" options={SORTS} width={150} />
        {filter.filtered && (
          <Button variant="subtle" onClick={filter.clear}>
            Clear
          </Button>
        )}
      </div>
      {tasks.data && <StateFilter filter={filter} counts={tasks.data.state_counts} />}
      {ticked.size > 0 && (
        <div className={classes.selectionBar}>
          {counted(ticked.size, "task")} chosen
          <Button onClick={() => setAssigning(true)}>Assign…</Button>
          <Button variant="subtle" onClick={() => setTicked(new Set())}>
            Clear
          </Button>
        </div>
      )}
      {tasks.isPending && <Loading what="tasks" />}
      {tasks.isError && <ProblemNotice error={tasks.error} onRetry={() => void tasks.refetch()} />}
      {tasks.data && tasks.data.items.length > 0 && (
        <>
          <TaskTable
            tasks={tasks.data.items}
            withAssignee
            {...(admin && { ticks: { ticked, onTick: setTicked } })}
          />
          <Pages filter={filter} total={tasks.data.total} pageSize={PAGE_SIZE} noun="task" />
        </>
      )}
      {tasks.data?.items.length === 0 && (
        <EmptyState title={filter.filtered ? "No task matches" : "There are no tasks yet"}>
          {filter.filtered ? (
            <Button variant="default" onClick={filter.clear}>
              Clear the filter
            </Button>
          ) : (
            <p>
              {admin ? "Create the first from the " : "An admin creates them from the "}
              <Link href="/logs">logs</Link>.
            </p>
          )}
        </EmptyState>
      )}
      {assigning && (
        <AssignDialog
          ids={[...ticked]}
          people={people.data ?? []}
          onClose={() => setAssigning(false)}
          onDone={assigned}
        />
      )}
    </div>
  );
}

import { Button } from "@mantine/core";
import { keepPreviousData, useQuery, useQueryClient } from "@tanstack/react-query";
import { useState } from "react";
import { listLogs } from "../../api/logs";
import { EmptyState } from "../parts/EmptyState";
import { Loading } from "../parts/Loading";
import { ProblemNotice } from "../parts/ProblemNotice";
import { counted } from "../parts/words";
import { useRole } from "../useSession";
import { CreateTasksDialog } from "./CreateTasksDialog";
import { CityAndSplit, SearchField } from "./filters";
import { LogTable } from "./LogTable";
import { PageHead } from "./PageHead";
import { Pages } from "./Pages";
import classes from "./pages.module.css";
import { useFilter } from "./useFilter";

const PAGE_SIZE = 50;

export function LogsPage() {
  const filter = useFilter();
  const admin = useRole() === "admin";
  const queryClient = useQueryClient();
  const [ticked, setTicked] = useState<ReadonlySet<string>>(new Set());
  const [creating, setCreating] = useState(false);
  const query = {
    q: filter.value("q"),
    page: filter.page,
    page_size: PAGE_SIZE,
    ...(filter.value("city") && { city: filter.value("city") }),
    ...(filter.value("split") && { split: filter.value("split") }),
  };
  const logs = useQuery({
    queryKey: ["logs", query],
    queryFn: () => listLogs(query),
    placeholderData: keepPreviousData,
  });
  const created = () => {
    setCreating(false);
    setTicked(new Set());
    void queryClient.invalidateQueries({ queryKey: ["logs"] });
    void queryClient.invalidateQueries({ queryKey: ["tasks"] });
  };
  return (
    <div className={classes.page}>
      <PageHead title="Logs" subtitle="Imported drives; a task edits the map of one." />
      <div className={classes.filters}>
        <SearchField filter={filter} label="Search logs" />
        <CityAndSplit filter={filter} />
      </div>
      {ticked.size > 0 && (
        <div className={classes.selectionBar}>
          {counted(ticked.size, "log")} chosen
          <Button onClick={() => setCreating(true)}>Create tasks…</Button>
          <Button variant="subtle" onClick={() => setTicked(new Set())}>
            Clear
          </Button>
        </div>
      )}
      {logs.isPending && <Loading what="logs" />}
      {logs.isError && <ProblemNotice error={logs.error} onRetry={() => void logs.refetch()} />}
      {logs.data && logs.data.items.length > 0 && (
        <>
          <LogTable logs={logs.data.items} {...(admin && { ticks: { ticked, onTick: setTicked } })} />
          <Pages filter={filter} total={logs.data.total} pageSize={PAGE_SIZE} noun="log" />
        </>
      )}
      {logs.data?.items.length === 0 && (
        <EmptyState title={filter.filtered ? "No log matches" : "No log is imported yet"}>
          {filter.filtered ? (
            <Button variant="default" onClick={filter.clear}>
              Clear the filter
            </Button>
          ) : (
            <>
              <p>Logs come from the command line of the server:</p>
              <code className={classes.code}>lanewright import PATH --split train</code>
            </>
          )}
        </EmptyState>
      )}
      {creating && (
        <CreateTasksDialog logIds={[...ticked]} onClose={() => setCreating(false)} onDone={created} />
      )}
    </div>
  );
}

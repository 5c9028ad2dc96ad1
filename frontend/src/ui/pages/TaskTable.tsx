import { Link } from "wouter";
import type { Task } from "../../api/types";
import { StateBadge } from "../parts/Badge";
import { ChangeBar } from "../parts/ChangeBar";
import { LogName } from "../parts/LogName";
import { useNow } from "../parts/useNow";
import { ago, DIRECTION_WORDS } from "../parts/words";
import { type Column, type Ticks, TickTable } from "./TickTable";

interface TaskTableProperties {
  tasks: readonly Task[];
  ticks?: Ticks<number>;
  withAssignee?: boolean;
}

const COLUMNS: Column<Task>[] = [
  { title: "Task", cell: (task) => <Link href={`/tasks/${task.id}`}>Task {task.id}</Link> },
  { title: "Log", cell: (task) => <LogName logId={task.log_id} /> },
  { title: "City", cell: (task) => task.city },
  { title: "Split", cell: (task) => task.release_split },
  { title: "Edits", cell: (task) => DIRECTION_WORDS[task.direction] },
  { title: "State", cell: (task) => <StateBadge state={task.state} /> },
  { title: "Changes", cell: (task) => <ChangeBar task={task} /> },
  { title: "Revision", cell: (task) => task.head, number: true },
];
const ASSIGNEE: Column<Task> = {
  title: "Assignee",
  cell: (task) => task.assignee?.name ?? <span className="third">nobody</span>,
};

export function TaskTable({ tasks, ticks, withAssignee = false }: TaskTableProperties) {
  const now = useNow();
  const since: Column<Task> = {
    title: "Since",
    cell: (task) => ago(task.state_since, now),
    hint: (task) => new Date(task.state_since).toLocaleString(),
  };
  return (
    <TickTable
      noun="task"
      rows={tasks}
      keyOf={(task) => task.id}
      columns={[...COLUMNS, ...(withAssignee ? [ASSIGNEE] : []), since]}
      ticks={ticks}
    />
  );
}

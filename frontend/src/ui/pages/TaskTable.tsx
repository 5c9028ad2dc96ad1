import { Checkbox } from "@mantine/core";
import type { ReactNode } from "react";
import { Link } from "wouter";
import type { Task } from "../../api/types";
import { StateBadge } from "../parts/Badge";
import { ChangeBar } from "../parts/ChangeBar";
import { LogName } from "../parts/LogName";
import { useNow } from "../parts/useNow";
import { ago, DIRECTION_WORDS } from "../parts/words";
import classes from "./pages.module.css";

interface TaskTableProperties {
  tasks: readonly Task[];
  /** Ticked tasks, where several can be taken at once. */
  ticked?: ReadonlySet<number>;
  onTick?: (ids: ReadonlySet<number>) => void;
  withAssignee?: boolean;
}

export function TaskTable({ tasks, ticked, onTick, withAssignee = false }: TaskTableProperties) {
  const now = useNow();
  const all = tasks.length > 0 && tasks.every((task) => ticked?.has(task.id));
  const tick = (id: number) => {
    const next = new Set(ticked);
    if (!next.delete(id)) next.add(id);
    onTick?.(next);
  };
  return (
    <table className={classes.table}>
      <thead>
        <tr>
          {onTick && (
            <th className={classes.tick}>
              <Checkbox
                aria-label="All tasks on this page"
                checked={all}
                onChange={() => onTick(new Set(all ? [] : tasks.map((task) => task.id)))}
              />
            </th>
          )}
          {["Task", "Log", "City", "Split", "Edits", "State", "Changes", "#", "Revision"].map((title) => (
            <th key={title} className={title === "#" ? classes.number : undefined}>
              {title}
            </th>
          ))}
          {withAssignee && <th>Assignee</th>}
          <th>Since</th>
        </tr>
      </thead>
      <tbody>
        {tasks.map((task) => (
          <tr key={task.id}>
            {onTick && (
              <td className={classes.tick}>
                <Checkbox
                  aria-label={`Task ${task.id}`}
                  checked={ticked?.has(task.id) ?? false}
                  onChange={() => tick(task.id)}
                />
              </td>
            )}
            <TaskCells task={task} />
            {withAssignee && <td>{task.assignee?.name ?? <span className="third">nobody</span>}</td>}
            <td title={new Date(task.state_since).toLocaleString()}>{ago(task.state_since, now)}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

function TaskCells({ task }: { task: Task }): ReactNode {
  return (
    <>
      <td>
        <Link href={`/tasks/${task.id}`}>Task {task.id}</Link>
      </td>
      <td>
        <LogName logId={task.log_id} />
      </td>
      <td>{task.city}</td>
      <td>{task.release_split}</td>
      <td>{DIRECTION_WORDS[task.direction]}</td>
      <td>
        <StateBadge state={task.state} />
      </td>
      <td>
        <ChangeBar task={task} />
      </td>
      <td className={classes.number}>{task.changed_elements}</td>
      <td>{task.head}</td>
    </>
  );
}

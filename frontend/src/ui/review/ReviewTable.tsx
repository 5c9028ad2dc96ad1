import { useEffect, useRef } from "react";
import type { Task } from "../../api/types";
import pages from "../pages/pages.module.css";
import { ChangeBar } from "../parts/ChangeBar";
import { LogName } from "../parts/LogName";
import { useNow } from "../parts/useNow";
import { duration, STATE_WORDS } from "../parts/words";

interface ReviewTableProperties {
  tasks: readonly Task[];
  chosen: number | undefined;
  onChoose: (task: Task) => void;
  onOpen: (task: Task) => void;
}

export function ReviewTable({ tasks, chosen, onChoose, onOpen }: ReviewTableProperties) {
  const now = useNow();
  const row = useRef<HTMLTableRowElement>(null);
  // biome-ignore lint/correctness/useExhaustiveDependencies: a newly chosen row is scrolled to
  useEffect(() => {
    row.current?.scrollIntoView({ block: "nearest" });
  }, [chosen]);
  return (
    <table className={pages.table} aria-label="Tasks that wait for review">
      <thead>
        <tr>
          <th>Log</th>
          <th>City</th>
          <th>Split</th>
          <th>Waiting</th>
          <th>Changes</th>
          <th>Author</th>
          <th>State</th>
        </tr>
      </thead>
      <tbody>
        {tasks.map((task) => (
          <tr
            key={task.id}
            ref={task.id === chosen ? row : undefined}
            data-clickable
            data-selected={task.id === chosen || undefined}
            aria-selected={task.id === chosen}
            onClick={() => onChoose(task)}
            onDoubleClick={() => onOpen(task)}
          >
            <td>
              <LogName logId={task.log_id} />
            </td>
            <td>{task.city}</td>
            <td>{task.release_split}</td>
            <td>{duration((now - new Date(task.state_since).getTime()) / 1000)}</td>
            <td>
              <ChangeBar task={task} />
            </td>
            <td>{task.authors.map((person) => person.name).join(", ") || "—"}</td>
            <td>{STATE_WORDS[task.state]}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

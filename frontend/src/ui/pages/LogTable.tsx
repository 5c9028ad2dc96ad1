import { Checkbox } from "@mantine/core";
import { Link } from "wouter";
import type { Log } from "../../api/types";
import { LogName } from "../parts/LogName";
import { DIRECTION_WORDS } from "../parts/words";
import classes from "./pages.module.css";

interface LogTableProperties {
  logs: readonly Log[];
  ticked?: ReadonlySet<string>;
  onTick?: (ids: ReadonlySet<string>) => void;
}

const sensorWords = (sensors: Record<string, number>) =>
  Object.entries(sensors)
    .map(([name, count]) => `${name} ${count}`)
    .join(", ");

export function LogTable({ logs, ticked, onTick }: LogTableProperties) {
  const all = logs.every((log) => ticked?.has(log.log_id));
  const tick = (id: string) => {
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
                aria-label="All logs on this page"
                checked={all}
                onChange={() => onTick(new Set(all ? [] : logs.map((log) => log.log_id)))}
              />
            </th>
          )}
          <th>Log</th>
          <th>City</th>
          <th>Split</th>
          <th>Edits</th>
          <th className={classes.number}>Lanes</th>
          <th className={classes.number}>Crossings</th>
          <th>Sensors</th>
          <th>Lacks</th>
          <th className={classes.number}>Tasks</th>
        </tr>
      </thead>
      <tbody>
        {logs.map((log) => (
          <tr key={log.log_id}>
            {onTick && (
              <td className={classes.tick}>
                <Checkbox
                  aria-label={`Log ${log.log_id}`}
                  checked={ticked?.has(log.log_id) ?? false}
                  onChange={() => tick(log.log_id)}
                />
              </td>
            )}
            <td>
              <LogName logId={log.log_id} />
            </td>
            <td>{log.city}</td>
            <td title={log.source_split === null ? undefined : `source split: ${log.source_split}`}>
              {log.release_split}
            </td>
            <td>{DIRECTION_WORDS[log.direction]}</td>
            <td className={classes.number}>{log.lanes}</td>
            <td className={classes.number}>{log.crossings}</td>
            <td>{sensorWords(log.sensors) || "—"}</td>
            <td>{log.absent.join(", ") || "—"}</td>
            <td className={classes.number}>
              <Link href={`/tasks?q=${encodeURIComponent(log.log_id)}`}>{log.tasks}</Link>
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

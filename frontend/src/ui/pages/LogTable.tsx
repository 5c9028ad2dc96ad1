import { Link } from "wouter";
import type { Log } from "../../api/types";
import { LogName } from "../parts/LogName";
import { DIRECTION_WORDS } from "../parts/words";
import { type Column, type Ticks, TickTable } from "./TickTable";

const sensorWords = (sensors: Record<string, number>) =>
  Object.entries(sensors)
    .map(([name, count]) => `${name} ${count}`)
    .join(", ");

const COLUMNS: Column<Log>[] = [
  { title: "Log", cell: (log) => <LogName logId={log.log_id} /> },
  { title: "City", cell: (log) => log.city },
  {
    title: "Split",
    cell: (log) => log.release_split,
    hint: (log) => (log.source_split === null ? undefined : `source split: ${log.source_split}`),
  },
  { title: "Edits", cell: (log) => DIRECTION_WORDS[log.direction] },
  { title: "Lanes", cell: (log) => log.lanes, number: true },
  { title: "Crossings", cell: (log) => log.crossings, number: true },
  { title: "Sensors", cell: (log) => sensorWords(log.sensors) || "—" },
  { title: "Lacks", cell: (log) => log.absent.join(", ") || "—", wraps: true },
  {
    title: "Tasks",
    cell: (log) => <Link href={`/tasks?q=${encodeURIComponent(log.log_id)}`}>{log.tasks}</Link>,
    number: true,
  },
];

export function LogTable({ logs, ticks }: { logs: readonly Log[]; ticks?: Ticks<string> }) {
  return <TickTable noun="log" rows={logs} keyOf={(log) => log.log_id} columns={COLUMNS} ticks={ticks} />;
}

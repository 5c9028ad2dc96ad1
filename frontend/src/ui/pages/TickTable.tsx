import { Checkbox } from "@mantine/core";
import type { ReactNode } from "react";
import classes from "./pages.module.css";

export interface Column<Row> {
  title: string;
  cell: (row: Row) => ReactNode;
  /** More than the cell has room for, shown on hover. */
  hint?: (row: Row) => string | undefined;
  number?: boolean;
  /** Long words may take several lines. */
  wraps?: boolean;
}

/** Ticked rows, where several can be taken at once. */
export interface Ticks<Key> {
  ticked: ReadonlySet<Key>;
  onTick: (keys: ReadonlySet<Key>) => void;
}

interface TickTableProperties<Row, Key> {
  /** What a row is: "task". */
  noun: string;
  rows: readonly Row[];
  keyOf: (row: Row) => Key;
  columns: readonly Column<Row>[];
  ticks?: Ticks<Key> | undefined;
}

/** A table whose rows can be ticked. */
export function TickTable<Row, Key extends string | number>(properties: TickTableProperties<Row, Key>) {
  const { noun, rows, keyOf, columns, ticks } = properties;
  const all = rows.length > 0 && rows.every((row) => ticks?.ticked.has(keyOf(row)));
  const tick = ({ ticked, onTick }: Ticks<Key>, key: Key) => {
    const next = new Set(ticked);
    if (!next.delete(key)) next.add(key);
    onTick(next);
  };
  return (
    <div className={classes.wide}>
      <table className={classes.table}>
        <thead>
          <tr>
            {ticks && (
              <th className={classes.tick}>
                <Checkbox
                  aria-label={`All ${noun}s on this page`}
                  checked={all}
                  onChange={() => ticks.onTick(new Set(all ? [] : rows.map(keyOf)))}
                />
              </th>
            )}
            {columns.map(({ title, number }) => (
              <th key={title} className={number ? classes.number : undefined}>
                {title}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {rows.map((row) => (
            <tr key={keyOf(row)}>
              {ticks && (
                <td className={classes.tick}>
                  <Checkbox
                    aria-label={`${noun[0]?.toUpperCase()}${noun.slice(1)} ${keyOf(row)}`}
                    checked={ticks.ticked.has(keyOf(row))}
                    onChange={() => tick(ticks, keyOf(row))}
                  />
                </td>
              )}
              {columns.map(({ title, cell, hint, number, wraps }) => (
                <td
                  key={title}
                  className={number ? classes.number : wraps ? classes.wraps : undefined}
                  title={hint?.(row)}
                >
                  {cell(row)}
                </td>
              ))}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

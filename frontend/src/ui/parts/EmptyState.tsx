import type { ReactNode } from "react";
import classes from "./parts.module.css";

/** An empty list: says that it is empty, and in its children what to do next. */
export function EmptyState({ title, children }: { title: string; children: ReactNode }) {
  return (
    <div className={classes.empty}>
      <h2>{title}</h2>
      {children}
    </div>
  );
}

import type { ReactNode } from "react";
import classes from "./workspace.module.css";

/** A line above the map for what holds as long as the workspace is open. */
export function Banner({ tone, children }: { tone: "plain" | "warning"; children: ReactNode }) {
  return (
    <div className={classes.banner} data-tone={tone} role="status">
      {children}
    </div>
  );
}

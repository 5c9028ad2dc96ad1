import { type ReactNode, useId } from "react";
import classes from "./inspector.module.css";

/** A label at the left and its control at the right. */
export function Field({ label, children }: { label: string; children: (id: string) => ReactNode }) {
  const id = useId();
  return (
    <div className={classes.field}>
      <label htmlFor={id}>{label}</label>
      {children(id)}
    </div>
  );
}

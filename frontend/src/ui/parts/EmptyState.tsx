import type { ReactNode } from "react";
import classes from "./parts.module.css";

interface EmptyStateProperties {
  title: string;
  /** Whether it is the whole page, and so its title the page's. */
  page?: boolean;
  children: ReactNode;
}

/** An empty list: says that it is empty, and in its children what to do next. */
export function EmptyState({ title, page = false, children }: EmptyStateProperties) {
  const Title = page ? "h1" : "h2";
  return (
    <div className={classes.empty}>
      <Title>{title}</Title>
      {children}
    </div>
  );
}

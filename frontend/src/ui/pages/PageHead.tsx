import { type ReactNode, useEffect } from "react";
import classes from "./pages.module.css";

interface PageHeadProperties {
  title: string;
  subtitle?: ReactNode;
  children?: ReactNode;
}

/** A page's title, also the window's; its actions stand at the right. */
export function PageHead({ title, subtitle, children }: PageHeadProperties) {
  useEffect(() => {
    document.title = `${title} · Lanewright`;
  }, [title]);
  return (
    <div className={classes.head}>
      <div>
        <h1>{title}</h1>
        {subtitle !== undefined && <p className={classes.subtitle}>{subtitle}</p>}
      </div>
      {children}
    </div>
  );
}

import type { ReactNode } from "react";
import { Link } from "wouter";
import { Badge } from "../parts/Badge";
import { ROLE_WORDS } from "../parts/words";
import { useSession } from "../useSession";
import { AccountMenu } from "./AccountMenu";
import { Navigation } from "./Navigation";
import classes from "./shell.module.css";

/** The frame of all pages but the workspace: header, navigation, and a main part that scrolls by itself. */
export function Shell({ children }: { children: ReactNode }) {
  const { account } = useSession();
  return (
    <div className={classes.shell}>
      <a className={classes.skip} href="#main">
        Skip to the page
      </a>
      <header className={classes.header}>
        <Link href="/" className={classes.brand}>
          Lanewright
        </Link>
        <span className={classes.right}>
          <Badge>{ROLE_WORDS[account.role]}</Badge>
          <AccountMenu />
        </span>
      </header>
      <Navigation />
      <main id="main" className={classes.main} tabIndex={-1}>
        {children}
      </main>
    </div>
  );
}

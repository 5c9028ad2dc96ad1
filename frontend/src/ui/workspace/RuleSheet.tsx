import { Drawer } from "@mantine/core";
import { lazy, Suspense } from "react";
import { Loading } from "../parts/Loading";
import { ruleTitle } from "../rules/ruleTitle";
import { useScreen, useWorkspace } from "./context";
import classes from "./workspace.module.css";

const RuleText = lazy(() => import("../rules/RuleText").then((module) => ({ default: module.RuleText })));

/** A rule's page beside the map: whoever reads it loses nothing of the work. */
export function RuleSheet() {
  const { screen } = useWorkspace();
  const code = useScreen((state) => state.rule);
  const open = (rule: string) => screen.setState({ rule });
  return (
    <Drawer
      opened={code !== null}
      onClose={() => screen.setState({ rule: null })}
      position="right"
      size={460}
      overlayProps={{ backgroundOpacity: 0.2 }}
      title={code === null ? "" : ruleTitle(code)}
    >
      {code !== null && (
        <Suspense fallback={<Loading what="the rule" />}>
          <p className={classes.ruleCode}>
            <span className="mono second">{code}</span>
            <a href={`/rules/${code}`} target="_blank" rel="noreferrer">
              Open in a tab
            </a>
          </p>
          <RuleText code={code} onOpen={open} />
        </Suspense>
      )}
    </Drawer>
  );
}

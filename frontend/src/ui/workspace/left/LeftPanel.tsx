import { Tabs } from "@mantine/core";
import type { ReactNode } from "react";
import { type LeftTab, useScreen, useWorkspace } from "../context";
import { Resizer } from "../Resizer";
import type { Commands } from "../useCommands";
import { useFindings } from "../useFindings";
import { ChangesTab } from "./ChangesTab";
import { FindTab } from "./FindTab";
import { HistoryTab } from "./HistoryTab";
import { IssuesTab } from "./IssuesTab";
import classes from "./left.module.css";

export function LeftPanel({ commands }: { commands: Commands }) {
  const { screen } = useWorkspace();
  const tab = useScreen((state) => state.tab);
  const { findings } = useFindings();
  const issues = findings?.violations.filter((violation) => !violation.inherited) ?? [];
  const errors = issues.some((violation) => violation.blocks);
  return (
    <aside className={classes.panel} aria-label="Lists">
      <h2 className="visually-hidden">Changes, issues and history</h2>
      <Tabs
        value={tab}
        onChange={(value) => value !== null && screen.setState({ tab: value as LeftTab })}
        keepMounted={false}
        classNames={{ root: classes.tabs ?? "", list: classes.tabList ?? "", tab: classes.tab ?? "" }}
      >
        <Tabs.List>
          <Tab name="changes" count={findings?.changes.length}>
            Changes
          </Tab>
          <Tab
            name="issues"
            count={findings === null ? undefined : issues.length}
            tone={errors ? "error" : undefined}
          >
            Issues
          </Tab>
          <Tab name="history">History</Tab>
          <Tab name="find">Find</Tab>
        </Tabs.List>
        <Tabs.Panel value="changes" className={classes.content}>
          <ChangesTab commands={commands} />
        </Tabs.Panel>
        <Tabs.Panel value="issues" className={classes.content}>
          <IssuesTab commands={commands} />
        </Tabs.Panel>
        <Tabs.Panel value="history" className={classes.content}>
          <HistoryTab />
        </Tabs.Panel>
        <Tabs.Panel value="find" className={classes.content}>
          <FindTab commands={commands} />
        </Tabs.Panel>
      </Tabs>
      <Resizer
        name="left"
        label="Width of the lists"
        initial={globalThis.innerWidth > 1100 ? 290 : 240}
        min={220}
        max={480}
        side="left"
      />
    </aside>
  );
}

interface TabProperties {
  name: LeftTab;
  count?: number | undefined;
  tone?: "error" | undefined;
  children: ReactNode;
}

function Tab({ name, count, tone, children }: TabProperties) {
  return (
    <Tabs.Tab
      value={name}
      rightSection={
        count === undefined ? undefined : (
          <span className={classes.tabCount} data-tone={tone}>
            {count}
          </span>
        )
      }
    >
      {children}
    </Tabs.Tab>
  );
}

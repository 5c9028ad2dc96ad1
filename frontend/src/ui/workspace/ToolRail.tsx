import { Tooltip } from "@mantine/core";
import { IconPointer } from "@tabler/icons-react";
import type { ComponentType } from "react";
import { KEY_TABLE, type KeyCommand, type Tool } from "../../editor";
import { useEditor, useWorkspace } from "./context";
import { CrossingIcon, CutIcon, LaneBesideIcon, LaneIcon } from "./toolIcons";
import classes from "./workspace.module.css";

interface ToolEntry {
  tool: Tool;
  command: KeyCommand;
  icon: ComponentType<{ size: number }>;
}

const TOOLS: readonly ToolEntry[] = [
  { tool: "select", command: "tool_select", icon: IconPointer },
  { tool: "draw_lane", command: "tool_draw_lane", icon: LaneIcon },
  { tool: "draw_crossing", command: "tool_draw_crossing", icon: CrossingIcon },
  { tool: "lane_beside", command: "tool_lane_beside", icon: LaneBesideIcon },
  { tool: "cut", command: "tool_cut", icon: CutIcon },
];

/** The shortest key of a command, and its words. */
function bindingOf(command: KeyCommand): { label: string; words: string } {
  const bindings = KEY_TABLE.filter((binding) => binding.command === command);
  const [shortest] = bindings.sort((a, b) => a.label.length - b.label.length);
  return shortest ?? { label: "", words: command };
}

export function ToolRail() {
  const { editor, mapRef, work } = useWorkspace();
  const current = useEditor((state) => state.tool);
  return (
    <aside className={classes.rail} aria-label="Tools">
      <div className={classes.tools} role="toolbar" aria-label="Tools" aria-orientation="vertical">
        {TOOLS.map(({ tool, command, icon: Icon }) => {
          const { label, words } = bindingOf(command);
          if (work === null && tool !== "select") return null;
          return (
            <Tooltip key={tool} label={`${words} (${label})`} position="right">
              <button
                type="button"
                className={classes.tool}
                aria-label={words}
                aria-pressed={current === tool}
                aria-keyshortcuts={label}
                onClick={() => {
                  editor.actions.setTool(tool);
                  mapRef.current?.focus();
                }}
              >
                <Icon size={19} />
                <span className={classes.toolKey} aria-hidden="true">
                  {label}
                </span>
              </button>
            </Tooltip>
          );
        })}
      </div>
    </aside>
  );
}

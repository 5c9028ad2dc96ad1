import { useEffect } from "react";
import { commandOf, type Editor, type KeyCommand, type Tool } from "../../editor";
import { useWorkspace } from "./context";
import type { Commands } from "./useCommands";

const TOOLS: Partial<Record<KeyCommand, Tool>> = {
  tool_select: "select",
  tool_draw_lane: "draw_lane",
  tool_lane_beside: "lane_beside",
  tool_draw_crossing: "draw_crossing",
  tool_cut: "cut",
};

/** Commands that mean the same wherever the focus is; arrows, Enter and Delete belong to what has the focus. */
function runEditorCommand(command: KeyCommand, editor: Editor): boolean {
  const { actions } = editor;
  const tool = TOOLS[command];
  if (tool !== undefined) actions.setTool(tool);
  else if (command === "undo") actions.undo();
  else if (command === "redo") actions.redo();
  else if (command === "cancel") actions.cancel();
  else if (command === "next_vertex") actions.stepVertex(1);
  else if (command === "previous_vertex") actions.stepVertex(-1);
  else return false;
  return true;
}

const isTyping = (target: EventTarget | null) =>
  target instanceof HTMLElement &&
  (target.isContentEditable || target.matches("input, textarea, select, [role=combobox]"));
const inDialog = () => document.querySelector("[role=dialog]") !== null;

/** The keys of the table with the focus anywhere but on the map, which has its own ear for them. */
export function useWorkspaceKeys(commands: Commands): void {
  const { editor, mapRef } = useWorkspace();
  useEffect(() => {
    const onKey = (event: KeyboardEvent) => {
      if (event.defaultPrevented) return;
      const command = commandOf(event);
      if (command === null) return;
      const held = event.type === "keydown";
      if (command === "flicker" && !isTyping(event.target)) {
        if (!event.repeat) commands.run({ name: "flicker", held });
      } else if (!held) return;
      else if (command === "save") commands.save();
      else if (isTyping(event.target) || inDialog()) return;
      else if (
        command === "help" ||
        command === "find" ||
        command === "next_issue" ||
        command === "canonical"
      )
        commands.run({ name: command });
      else if (command === "next_frame" || command === "previous_frame") commands.run({ name: command });
      else if (command === "join" || command === "reverse") mapRef.current?.editLane(command);
      else if (command === "fit_log") mapRef.current?.fitLog();
      else if (command === "fit_element") {
        const { selection } = editor.getState();
        if (selection !== null) mapRef.current?.fitElement(selection);
      } else if (!runEditorCommand(command, editor)) return;
      event.preventDefault();
    };
    document.addEventListener("keydown", onKey);
    document.addEventListener("keyup", onKey);
    return () => {
      document.removeEventListener("keydown", onKey);
      document.removeEventListener("keyup", onKey);
    };
  }, [commands, editor, mapRef]);
}

import { useMediaQuery } from "@mantine/hooks";
import { type ReactNode, useEffect, useMemo, useRef } from "react";
import type { Workspace } from "../../api/types";
import type { Editor } from "../../editor";
import type { MapHandle } from "../../map";
import type { WorkSession } from "../../work/workSession";
import { shortLogName } from "../parts/words";
import { createScreen, useEditor, useScreen, useWorkspace, WorkspaceContext } from "./context";
import { Inspector } from "./inspector/Inspector";
import { KeysSheet } from "./KeysSheet";
import { LeftPanel } from "./left/LeftPanel";
import { MapArea } from "./MapArea";
import { RuleSheet } from "./RuleSheet";
import { SentBack } from "./SentBack";
import { StaleDialog } from "./StaleDialog";
import { ToolRail } from "./ToolRail";
import { useAddress } from "./useAddress";
import { useCommands } from "./useCommands";
import { useNotices } from "./useNotices";
import { useWorkspaceKeys } from "./useWorkspaceKeys";
import { WorkHeader } from "./WorkHeader";
import classes from "./workspace.module.css";

interface WorkspaceScreenProperties {
  workspace: Workspace;
  editor: Editor;
  work: WorkSession | null;
  reopen: () => void;
  banner?: ReactNode;
}

export function WorkspaceScreen({ workspace, editor, work, reopen, banner }: WorkspaceScreenProperties) {
  const screen = useMemo(() => createScreen(workspace), [workspace]);
  const mapRef = useRef<MapHandle>(null);
  const value = useMemo(
    () => ({ workspace, editor, work, screen, mapRef, reopen }),
    [workspace, editor, work, screen, reopen],
  );
  useEffect(() => {
    document.title = `${shortLogName(workspace.task.log_id)} · task ${workspace.task.id} · Lanewright`;
  }, [workspace]);
  return (
    <WorkspaceContext value={value}>
      <Screen banner={banner} />
    </WorkspaceContext>
  );
}

/** Where room is short, the inspector is a drawer over the map, there only for what is selected. */
function useInspectorShown(): boolean {
  const narrow = useMediaQuery("(max-width: 1100px)");
  const selected = useEditor((state) => state.selection !== null);
  const shown = useScreen((state) => state.inspectorShown);
  return shown && (selected || !narrow);
}

function Screen({ banner }: { banner: ReactNode }) {
  const { work } = useWorkspace();
  const commands = useCommands();
  useAddress();
  useNotices();
  useWorkspaceKeys(commands);
  const leftShown = useScreen((state) => state.leftShown);
  const inspectorShown = useInspectorShown();

  const { saveOnOpen } = commands;
  useEffect(() => {
    if (work === null) return;
    work.start();
    saveOnOpen();
    return () => work.stop();
  }, [work, saveOnOpen]);

  return (
    <div className={classes.screen}>
      <WorkHeader commands={commands} />
      {banner}
      <SentBack />
      <div className={classes.body} data-workspace data-inspector={inspectorShown || undefined}>
        <ToolRail />
        {leftShown && <LeftPanel commands={commands} />}
        <MapArea commands={commands} />
        {inspectorShown && <Inspector />}
      </div>
      <KeysSheet />
      <StaleDialog />
      <RuleSheet />
    </div>
  );
}

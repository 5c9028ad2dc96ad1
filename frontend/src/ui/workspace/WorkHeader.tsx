import { Button, Tooltip } from "@mantine/core";
import {
  IconArrowBackUp,
  IconArrowForwardUp,
  IconLayoutSidebar,
  IconLayoutSidebarRight,
} from "@tabler/icons-react";
import type { ReactNode } from "react";
import { Link } from "wouter";
import { Badge, StateBadge } from "../parts/Badge";
import { DIRECTION_WORDS, shortLogName } from "../parts/words";
import { AccountMenu } from "../shell/AccountMenu";
import { useEditor, useScreen, useWorkspace } from "./context";
import { Decisions } from "./Decisions";
import { ReadingStatus } from "./ReadingStatus";
import { SaveButtons } from "./SaveButtons";
import { SavingStatus } from "./SavingStatus";
import type { Commands } from "./useCommands";
import classes from "./workspace.module.css";

export function WorkHeader({ commands }: { commands: Commands }) {
  const { work, screen } = useWorkspace();
  const task = useScreen((state) => state.task);
  const flicker = useScreen((state) => state.flicker);
  const hold = (held: boolean) => commands.run({ name: "flicker", held });
  return (
    <header className={classes.header}>
      <Link href="/" className={classes.brand} title="My tasks">
        <span className={classes.brandName}>Lanewright</span>
        <img className={classes.brandMark} src="/favicon.svg" width={22} height={22} alt="Lanewright" />
      </Link>
      <h1 className="visually-hidden">Task {task.id}</h1>
      <span className={classes.crumbs}>
        {task.city} / {task.release_split} / <strong title={task.log_id}>{shortLogName(task.log_id)}</strong>
      </span>
      <StateBadge state={task.state} />
      <Badge>edits: {DIRECTION_WORDS[task.direction]}</Badge>
      <div className={classes.status}>
        {work === null ? <ReadingStatus /> : <SavingStatus commands={commands} />}
      </div>
      {work !== null && <History />}
      <Tooltip label="Hold to see the other state">
        <Button
          variant="default"
          rightSection={<kbd>`</kbd>}
          aria-pressed={flicker}
          onPointerDown={() => hold(true)}
          onPointerUp={() => hold(false)}
          onPointerLeave={() => flicker && hold(false)}
        >
          Compare
        </Button>
      </Tooltip>
      {work !== null && <SaveButtons commands={commands} />}
      <Decisions />
      <span className={classes.iconButtons}>
        <PanelToggle name="leftShown" label="Lists" icon={<IconLayoutSidebar size={17} aria-hidden />} />
        <PanelToggle
          name="inspectorShown"
          label="Inspector"
          icon={<IconLayoutSidebarRight size={17} aria-hidden />}
        />
        <button
          type="button"
          className={classes.iconButton}
          aria-label="Keys"
          title="Keys (?)"
          onClick={() => screen.setState({ keysShown: true })}
        >
          ?
        </button>
      </span>
      <AccountMenu compact />
    </header>
  );
}

function History() {
  const { editor } = useWorkspace();
  const undo = useEditor((state) => state.history.done.at(-1)?.note);
  const redo = useEditor((state) => state.history.undone.at(-1)?.note);
  return (
    <Button.Group>
      <Button
        variant="default"
        aria-label="Undo"
        px={9}
        disabled={undo === undefined}
        title={undo === undefined ? "Nothing to undo" : `Undo: ${undo} (Ctrl Z)`}
        onClick={() => editor.actions.undo()}
      >
        <IconArrowBackUp size={16} aria-hidden />
      </Button>
      <Button
        variant="default"
        aria-label="Redo"
        px={9}
        disabled={redo === undefined}
        title={redo === undefined ? "Nothing to redo" : `Redo: ${redo} (Ctrl Shift Z)`}
        onClick={() => editor.actions.redo()}
      >
        <IconArrowForwardUp size={16} aria-hidden />
      </Button>
    </Button.Group>
  );
}

interface PanelToggleProperties {
  name: "leftShown" | "inspectorShown";
  label: string;
  icon: ReactNode;
}

function PanelToggle({ name, label, icon }: PanelToggleProperties) {
  const { screen } = useWorkspace();
  const shown = useScreen((state) => state[name]);
  return (
    <button
      type="button"
      className={classes.iconButton}
      aria-label={label}
      aria-pressed={shown}
      title={`${shown ? "Hide" : "Show"} the ${label.toLowerCase()}`}
      onClick={() => screen.setState({ [name]: !shown })}
    >
      {icon}
    </button>
  );
}

/** Keys with the map focused. What the page has to do goes to it as a command. */
import { commandOf, type Editor, type KeyCommand, nudgeOf } from "../editor";
import { NOT_EDITED } from "./input";
import type { MapController } from "./mapController";
import type { LaneCommand, MapHandle, PageCommand } from "./properties";

const PAN_PIXELS = 80;

type Run = (event: KeyboardEvent) => void;

export interface KeyboardOptions {
  readonly onCommand: (command: PageCommand) => void;
  /** The imported map is on the screen, which nobody edits. */
  readonly showsBase: () => boolean;
}

const EDITING: ReadonlySet<KeyCommand> = new Set(["remove", "add_vertex", "nudge"]);

export function attachKeyboard(
  { map, region }: MapController,
  editor: Editor,
  handle: MapHandle,
  { onCommand, showsBase }: KeyboardOptions,
): () => void {
  const { actions } = editor;
  const page =
    (name: Exclude<PageCommand["name"], "flicker">): Run =>
    () =>
      onCommand({ name });

  const commands: Readonly<Record<KeyCommand, Run>> = {
    tool_select: () => actions.setTool("select"),
    tool_draw_lane: () => actions.setTool("draw_lane"),
    tool_lane_beside: () => actions.setTool("lane_beside"),
    tool_draw_crossing: () => actions.setTool("draw_crossing"),
    tool_cut: () => actions.setTool("cut"),
    join: () => handle.editLane("join"),
    reverse: () => handle.editLane("reverse"),
    cancel: () => actions.cancel(),
    finish: () => {
      if (editor.getState().sketch === null) onCommand({ name: "apply_fix" });
      else void actions.finishSketch();
    },
    undo: () => actions.undo(),
    redo: () => actions.redo(),
    remove: () => {
      if (editor.getState().sketch !== null) actions.sketchBack();
      else actions.removeSelected();
    },
    add_vertex: () => addAfterSelected(editor),
    next_vertex: () => actions.stepVertex(1),
    previous_vertex: () => actions.stepVertex(-1),
    nudge: (event) => {
      const by = nudgeOf(event);
      if (editor.getState().selection !== null) actions.nudge(by);
      else map.panBy([Math.sign(by.x) * PAN_PIXELS, -Math.sign(by.y) * PAN_PIXELS], { duration: 120 });
    },
    next_underneath: () => actions.pickUnderneath(),
    fit_element: () => {
      const { selection } = editor.getState();
      if (selection !== null) handle.fitElement(selection);
    },
    fit_log: () => handle.fitLog(),
    zoom_in: () => map.zoomIn({ duration: 150 }),
    zoom_out: () => map.zoomOut({ duration: 150 }),
    flicker: (event) => {
      if (!event.repeat) onCommand({ name: "flicker", held: true });
    },
    save: page("save"),
    next_issue: page("next_issue"),
    next_frame: page("next_frame"),
    previous_frame: page("previous_frame"),
    find: page("find"),
    help: page("help"),
    canonical: page("canonical"),
  };

  const onDown = (event: KeyboardEvent) => {
    const command = commandOf(event);
    if (command === null || isElsewhere(event)) return;
    event.preventDefault();
    event.stopPropagation();
    if (showsBase() && EDITING.has(command) && editor.getState().selection !== null) actions.say(NOT_EDITED);
    else commands[command](event);
  };
  const onUp = (event: KeyboardEvent) => {
    if (commandOf(event) !== "flicker") return;
    event.stopPropagation();
    onCommand({ name: "flicker", held: false });
  };
  /** The key's release is not seen by a page that lost the focus. */
  const onBlur = () => onCommand({ name: "flicker", held: false });

  region.addEventListener("keydown", onDown);
  region.addEventListener("keyup", onUp);
  window.addEventListener("blur", onBlur);
  return () => {
    region.removeEventListener("keydown", onDown);
    region.removeEventListener("keyup", onUp);
    window.removeEventListener("blur", onBlur);
  };
}

/** Enter and Space on a button press it; fields take what is typed. */
function isElsewhere({ target, key }: KeyboardEvent): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.matches("input, textarea, select, [contenteditable]")) return true;
  return target.matches("button") && (key === "Enter" || key === " ");
}

/** Join the selected lane with the next one, or turn it round; not while the imported map is on the screen. */
export function editLane({ getState, actions }: Editor, command: LaneCommand, showsBase: boolean): void {
  const { selection } = getState();
  if (selection?.kind !== "lane_segment") actions.say("Select a lane first.");
  else if (showsBase) actions.say(NOT_EDITED);
  else if (command === "join") void actions.joinLane(selection.id);
  else actions.reverseLane(selection.id);
}

function addAfterSelected(editor: Editor): void {
  const { selection } = editor.getState();
  if (selection?.vertex)
    editor.actions.addVertex({ kind: selection.kind, id: selection.id, ...selection.vertex });
  else editor.actions.say("Select a vertex first: [ and ] step through them.");
}

/** The one table of keys: what the map obeys and what the "?" sheet shows. */

export type KeyCommand =
  | "tool_select"
  | "tool_draw_lane"
  | "tool_lane_beside"
  | "tool_draw_crossing"
  | "tool_cut"
  | "join"
  | "reverse"
  | "cancel"
  | "finish"
  | "undo"
  | "redo"
  | "save"
  | "remove"
  | "add_vertex"
  | "next_vertex"
  | "previous_vertex"
  | "nudge"
  | "next_underneath"
  | "fit_element"
  | "fit_log"
  | "zoom_in"
  | "zoom_out"
  | "flicker"
  | "next_issue"
  | "canonical"
  | "next_frame"
  | "previous_frame"
  | "find"
  | "help";

export interface KeyBinding {
  readonly command: KeyCommand;
  /** As `KeyboardEvent.key` in lower case, or its physical `code` where layouts differ (`Backquote`, `Digit2`). */
  readonly keys: readonly string[];
  /** Ctrl, or Command on a Mac. */
  readonly control?: boolean;
  /** Left out: does not matter. */
  readonly shift?: boolean;
  /** How the sheet writes it. */
  readonly label: string;
  readonly words: string;
  readonly group: "Tools" | "Edit" | "Select" | "View" | "Work";
}

export const KEY_TABLE: readonly KeyBinding[] = [
  { command: "tool_select", keys: ["1"], label: "1", words: "Select and move", group: "Tools" },
  { command: "tool_draw_lane", keys: ["2"], shift: false, label: "2", words: "Draw a lane", group: "Tools" },
  { command: "tool_draw_crossing", keys: ["3"], label: "3", words: "Draw a crossing", group: "Tools" },
  {
    command: "tool_lane_beside",
    keys: ["Digit2"],
    shift: true,
    label: "Shift 2",
    words: "Lane beside another",
    group: "Tools",
  },
  { command: "tool_lane_beside", keys: ["b"], label: "B", words: "Lane beside another", group: "Tools" },
  {
    command: "tool_cut",
    keys: ["x"],
    label: "X",
    words: "Cut a lane where a property changes",
    group: "Tools",
  },
  {
    command: "finish",
    keys: ["enter"],
    label: "Enter",
    words: "Finish drawing; else apply the offered fix",
    group: "Tools",
  },
  {
    command: "cancel",
    keys: ["escape"],
    label: "Esc",
    words: "Cancel the drag, the drawing, the tool, the selection",
    group: "Tools",
  },
  {
    command: "undo",
    keys: ["z"],
    control: true,
    shift: false,
    label: "Ctrl Z",
    words: "Undo",
    group: "Edit",
  },
  {
    command: "redo",
    keys: ["z"],
    control: true,
    shift: true,
    label: "Ctrl Shift Z",
    words: "Redo",
    group: "Edit",
  },
  { command: "redo", keys: ["y"], control: true, label: "Ctrl Y", words: "Redo", group: "Edit" },
  {
    command: "remove",
    keys: ["delete", "backspace"],
    label: "Delete",
    words: "Delete the selected vertex or element; take back a click while drawing",
    group: "Edit",
  },
  {
    command: "add_vertex",
    keys: ["a"],
    label: "A",
    words: "Add a vertex after the selected one",
    group: "Edit",
  },
  {
    command: "join",
    keys: ["c"],
    label: "C",
    words: "Join the selected lane with the one in series that it was cut from",
    group: "Edit",
  },
  {
    command: "reverse",
    keys: ["v"],
    label: "V",
    words: "Turn the selected lane round (one that you drew)",
    group: "Edit",
  },
  {
    command: "nudge",
    keys: ["arrowup", "arrowdown", "arrowleft", "arrowright"],
    label: "Arrows",
    words: "Move the selected vertex or element by 0.05 m, with Shift 0.5 m",
    group: "Edit",
  },
  { command: "next_vertex", keys: ["]"], label: "]", words: "Next vertex", group: "Select" },
  { command: "previous_vertex", keys: ["["], label: "[", words: "Previous vertex", group: "Select" },
  {
    command: "next_underneath",
    keys: ["\\"],
    label: "\\",
    words: "Next element underneath (or click again)",
    group: "Select",
  },
  { command: "find", keys: ["/"], label: "/", words: "Find an element by its id", group: "Select" },
  {
    command: "fit_element",
    keys: ["z"],
    shift: false,
    label: "Z",
    words: "Zoom to the selected element",
    group: "View",
  },
  { command: "fit_log", keys: ["0"], label: "0", words: "Show the whole log", group: "View" },
  { command: "zoom_in", keys: ["+", "="], label: "+", words: "Closer", group: "View" },
  { command: "zoom_out", keys: ["-"], label: "-", words: "Farther", group: "View" },
  {
    command: "flicker",
    keys: ["Backquote"],
    label: "` (hold)",
    words: "Show the other state while held",
    group: "View",
  },
  { command: "next_frame", keys: ["f"], label: "F", words: "Next frame", group: "View" },
  { command: "previous_frame", keys: ["d"], label: "D", words: "Previous frame", group: "View" },
  { command: "save", keys: ["s"], control: true, label: "Ctrl S", words: "Save a revision", group: "Work" },
  { command: "next_issue", keys: ["n"], label: "N", words: "Next issue", group: "Work" },
  {
    command: "canonical",
    keys: ["m"],
    label: "M",
    words: "Make canonical: the same map, told with the fewest changes",
    group: "Work",
  },
  { command: "help", keys: ["?"], label: "?", words: "This sheet", group: "Work" },
];

/** What of a keyboard event the table looks at. */
export interface KeyPress {
  readonly key: string;
  readonly code: string;
  readonly ctrlKey: boolean;
  readonly metaKey: boolean;
  readonly shiftKey: boolean;
  readonly altKey: boolean;
}

export function commandOf(press: KeyPress): KeyCommand | null {
  if (press.altKey) return null;
  const control = press.ctrlKey || press.metaKey;
  const binding = KEY_TABLE.find(
    ({ keys, control: wantsControl = false, shift }) =>
      wantsControl === control &&
      (shift === undefined || shift === press.shiftKey) &&
      keys.some((key) => key === press.key.toLowerCase() || key === press.code),
  );
  return binding?.command ?? null;
}

/** A nudge's offset in metres, north up. */
export function nudgeOf(press: KeyPress): { x: number; y: number } {
  const step = press.shiftKey ? 0.5 : 0.05;
  const directions: Readonly<Record<string, readonly [number, number]>> = {
    arrowup: [0, 1],
    arrowdown: [0, -1],
    arrowleft: [-1, 0],
    arrowright: [1, 0],
  };
  const [x, y] = directions[press.key.toLowerCase()] ?? [0, 0];
  return { x: x * step, y: y * step };
}

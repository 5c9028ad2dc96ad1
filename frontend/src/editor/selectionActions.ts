/** Selecting, hovering, tools. */
import { elementOf } from "./document";
import { keyText } from "./elements";
import { lineNames, lineOf } from "./lines";
import { elementsAt, nearestLineName, nextOfStack } from "./picking";
import type { Stage } from "./stage";
import type { EditorActions, Selection } from "./state";

type SelectionActions = Pick<
  EditorActions,
  "select" | "pick" | "pickUnderneath" | "hover" | "stepVertex" | "setTool" | "cancel" | "say"
>;

export function selectionActions(stage: Stage): SelectionActions {
  const { store } = stage;
  let lastPlace: { x: number; y: number } | null = null;

  const choose = (selection: Selection | null) => store.setState({ selection, staged: null });

  const pick: EditorActions["pick"] = (place, tolerance, of = "current") => {
    const { current, base, selection } = stage.state;
    const here = elementsAt(of === "base" ? base : current, place, tolerance);
    const stack = here.length > 0 ? here : elementsAt(base, place, tolerance).filter(isDeleted);
    const again = lastPlace !== null && Math.hypot(place.x - lastPlace.x, place.y - lastPlace.y) <= tolerance;
    lastPlace = place;
    const key = nextOfStack(stack, again ? selection : null);
    if (key === null) {
      choose(null);
      return;
    }
    const element = elementOf(of === "base" ? base : current, key);
    const line = element && nearestLineName(element, place);
    const side = line !== null && line.distance <= tolerance ? line.name : null;
    choose({ ...key, side, vertex: null });
  };

  const isDeleted = (key: { kind: "lane_segment" | "pedestrian_crossing"; id: number }) =>
    elementOf(stage.state.current, key) === null;

  return {
    select: (key, detail = {}) =>
      choose(
        key && {
          kind: key.kind,
          id: key.id,
          side: detail.vertex?.side ?? detail.side ?? null,
          vertex: detail.vertex ?? null,
        },
      ),
    pick,
    pickUnderneath: () => {
      if (lastPlace !== null) pick(lastPlace, 0.5);
    },
    hover: (key) => {
      const { hover } = stage.state;
      if ((key && keyText(key)) !== (hover && keyText(hover))) store.setState({ hover: key });
    },
    stepVertex: (step) => {
      const { selection, current } = stage.state;
      const element = selection && elementOf(current, selection);
      if (selection === null || element === null) return;
      const all = lineNames(element.kind).flatMap((side) =>
        (lineOf(element, side) ?? []).map((_, index) => ({ side, index })),
      );
      const { vertex } = selection;
      const at = vertex
        ? all.findIndex(({ side, index }) => side === vertex.side && index === vertex.index)
        : -1;
      const start = at === -1 && step === -1 ? 0 : at;
      const next = all[(start + step + all.length) % all.length];
      if (next !== undefined) choose({ ...selection, side: next.side, vertex: next });
    },
    setTool: (tool) => {
      if (stage.state.readOnly && tool !== "select") {
        stage.refuse("This task is open for reading only.");
        return;
      }
      if (tool !== "select") stage.prepareIds();
      store.setState({ tool, sketch: null, staged: null });
    },
    cancel: () => {
      const { staged, sketch, tool, selection } = stage.state;
      if (staged !== null) store.setState({ staged: null });
      else if (sketch !== null) store.setState({ sketch: null });
      else if (tool !== "select") store.setState({ tool: "select" });
      else if (selection?.vertex) store.setState({ selection: { ...selection, vertex: null } });
      else store.setState({ selection: null });
    },
    say: (text) => stage.say(text),
  };
}

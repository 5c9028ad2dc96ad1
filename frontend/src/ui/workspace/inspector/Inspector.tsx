import { baseCutAlike, elementOf, keyText, type MapElement } from "../../../editor";
import { KIND_WORDS } from "../../parts/words";
import { useEditor, useScreen, useWorkspace } from "../context";
import { Resizer } from "../Resizer";
import { Attribution } from "./Attribution";
import { CrossingInspector } from "./CrossingInspector";
import { ElementActions } from "./ElementActions";
import { ElementChange } from "./ElementChange";
import classes from "./inspector.module.css";
import { LaneInspector } from "./LaneInspector";
import { RemarkField } from "./RemarkField";
import { ReviewRemarks } from "./ReviewRemarks";

/** The selected element, with what a drag that goes on does to it. */
function useSelectedElement(): { now: MapElement | null; base: MapElement | null } {
  const selection = useEditor((state) => state.selection);
  const current = useEditor((state) => state.current);
  const imported = useEditor((state) => state.base);
  const staged = useEditor((state) => state.staged);
  if (selection === null) return { now: null, base: null };
  const change = staged?.changes.find(({ key }) => keyText(key) === keyText(selection));
  const base = baseCutAlike(imported, current);
  return { now: change?.after ?? elementOf(current, selection), base: elementOf(base, selection) };
}

export function Inspector() {
  const { now, base } = useSelectedElement();
  const shown = now ?? base;
  return (
    <aside className={classes.inspector} aria-label="Inspector">
      <Resizer
        name="inspector"
        label="Width of the inspector"
        initial={300}
        min={240}
        max={440}
        side="right"
      />
      <div className={classes.content}>
        {shown === null ? (
          <NothingSelected />
        ) : (
          <Selected key={keyText(shown)} now={now} base={base} shown={shown} />
        )}
      </div>
    </aside>
  );
}

function Selected({
  now,
  base,
  shown,
}: {
  now: MapElement | null;
  base: MapElement | null;
  shown: MapElement;
}) {
  const { work } = useWorkspace();
  const task = useScreen((state) => state.task);
  const whole = now?.kind === "lane_segment" && base !== null ? now.attributes.part_of : null;
  const state =
    now === null ? "deleted" : base === null ? "inserted" : whole === null ? null : `part of lane ${whole}`;
  return (
    <>
      <header>
        <h2>{shown.kind === "lane_segment" ? "Lane segment" : "Pedestrian crossing"}</h2>
        <p className="mono second">
          {shown.id}
          {state !== null && ` · ${state}`}
        </p>
      </header>
      {shown.kind === "lane_segment" ? (
        <LaneInspector
          lane={shown.attributes}
          base={base?.kind === "lane_segment" ? base.attributes : null}
          editable={work !== null && now !== null}
        />
      ) : (
        <CrossingInspector crossing={shown} base={base?.kind === "pedestrian_crossing" ? base : null} />
      )}
      <ReviewRemarks element={shown} />
      {work !== null && <ElementActions element={shown} deleted={now === null} changed={now !== base} />}
      <ElementChange element={shown} />
      {task.actions.includes("send_back") || task.actions.includes("start_review") ? (
        <RemarkField element={shown} />
      ) : null}
      <Attribution element={shown} deleted={now === null} />
    </>
  );
}

function NothingSelected() {
  const { work } = useWorkspace();
  const lanes = useEditor((state) => state.current.lanes.size);
  const crossings = useEditor((state) => state.current.crossings.size);
  return (
    <div className={classes.nothing}>
      <h2>Nothing selected</h2>
      <p>
        Click a {KIND_WORDS.lane_segment.toLowerCase()} or {KIND_WORDS.pedestrian_crossing.toLowerCase()} on
        the map, or a row of the lists. A further click at the same place takes the one below.
      </p>
      <p>
        {lanes} lanes and {crossings} crossings{work === null ? ", only to look at" : ""}. Press <kbd>?</kbd>{" "}
        for all keys.
      </p>
    </div>
  );
}

import { IconUnlink } from "@tabler/icons-react";
import { type Lane, linkedLanes } from "../../../editor";
import { useEditor, useWorkspace } from "../context";
import classes from "./inspector.module.css";

/** The lane's place in the road graph; a click goes there. */
export function LaneLinks({ lane, editable }: { lane: Lane; editable: boolean }) {
  const { actions } = useWorkspace().editor;
  const current = useEditor((state) => state.current);
  const neighbours = (id: number | null) => (id === null ? [] : [id]);
  // Real maps write many links on one side only, so both sides are asked; the lane's own list tells the order.
  const linked = (own: readonly number[], way: "before" | "after") => [
    ...new Set([...own, ...linkedLanes(current, lane.id, way)]),
  ];
  return (
    <section className={classes.section}>
      <h3 className="label">Place in the road graph</h3>
      <Links
        words="from"
        ids={linked(lane.predecessors, "before")}
        onUnlink={editable ? (id) => actions.unlink(id, lane.id) : undefined}
      />
      <Links
        words="to"
        ids={linked(lane.successors, "after")}
        onUnlink={editable ? (id) => actions.unlink(lane.id, id) : undefined}
      />
      <Links words="left" ids={neighbours(lane.left_neighbor_id)} />
      <Links words="right" ids={neighbours(lane.right_neighbor_id)} />
    </section>
  );
}

interface LinksProperties {
  words: string;
  ids: readonly number[];
  onUnlink?: ((id: number) => void) | undefined;
}

function Links({ words, ids, onUnlink }: LinksProperties) {
  const { editor, mapRef } = useWorkspace();
  const lanes = useEditor((state) => state.current.lanes);
  const go = (id: number) => {
    const key = { kind: "lane_segment" as const, id };
    editor.actions.select(key);
    mapRef.current?.fitElement(key);
  };
  return (
    <p className={classes.links}>
      <span className="second">{words}</span>
      {ids.length === 0 && <span className="third">none</span>}
      {ids.map((id) =>
        lanes.has(id) ? (
          <span key={id} className={classes.linked}>
            <button
              type="button"
              className={classes.link}
              onClick={() => go(id)}
              onMouseEnter={() => editor.actions.hover({ kind: "lane_segment", id })}
              onMouseLeave={() => editor.actions.hover(null)}
            >
              {id}
            </button>
            {onUnlink !== undefined && (
              <button
                type="button"
                className={classes.unlink}
                aria-label={`Unlink ${words} lane ${id}`}
                title="Take this link out; the ends can then be dragged apart"
                onClick={() => onUnlink(id)}
              >
                <IconUnlink size={13} aria-hidden />
              </button>
            )}
          </span>
        ) : (
          <span key={id} className="third" title="Outside this crop of the map">
            {id}
          </span>
        ),
      )}
    </p>
  );
}

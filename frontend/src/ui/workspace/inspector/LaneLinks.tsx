import type { Lane } from "../../../editor";
import { useEditor, useWorkspace } from "../context";
import classes from "./inspector.module.css";

/** The lane's place in the road graph; a click goes there. */
export function LaneLinks({ lane }: { lane: Lane }) {
  const neighbours = (id: number | null) => (id === null ? [] : [id]);
  return (
    <section className={classes.section}>
      <h3 className="label">Place in the road graph</h3>
      <Links words="from" ids={lane.predecessors} />
      <Links words="to" ids={lane.successors} />
      <Links words="left" ids={neighbours(lane.left_neighbor_id)} />
      <Links words="right" ids={neighbours(lane.right_neighbor_id)} />
    </section>
  );
}

function Links({ words, ids }: { words: string; ids: readonly number[] }) {
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
          <button
            key={id}
            type="button"
            className={classes.link}
            onClick={() => go(id)}
            onMouseEnter={() => editor.actions.hover({ kind: "lane_segment", id })}
            onMouseLeave={() => editor.actions.hover(null)}
          >
            {id}
          </button>
        ) : (
          <span key={id} className="third" title="Outside this crop of the map">
            {id}
          </span>
        ),
      )}
    </p>
  );
}

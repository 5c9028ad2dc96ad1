import { type MapElement, measuresOf } from "../../../editor";
import classes from "./inspector.module.css";
import { Measure } from "./Measure";

export function CrossingInspector({ crossing, base }: { crossing: MapElement; base: MapElement | null }) {
  const now = measuresOf(crossing);
  const before = base === null ? null : measuresOf(base);
  return (
    <div className={classes.fields}>
      <Measure label="Length" metres={now.length} before={before?.length ?? null} />
      <Measure label="Width" metres={now.width} before={before?.width ?? null} />
    </div>
  );
}

import classes from "./inspector.module.css";

const metres2 = (metres: number) => `${metres.toFixed(2)} m`;

/** A live figure, with what it was in the imported map where that differs. */
export function Measure({ label, metres, before }: { label: string; metres: number; before: number | null }) {
  const differs = before !== null && Math.abs(before - metres) >= 0.005;
  return (
    <div className={classes.field}>
      <span>{label}</span>
      <output className={classes.measure} aria-label={label}>
        {metres2(metres)}
        {differs && <span className="third">was {metres2(before)}</span>}
      </output>
    </div>
  );
}

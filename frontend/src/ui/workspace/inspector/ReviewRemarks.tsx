import type { MapElement } from "../../../editor";
import { useNow } from "../../parts/useNow";
import { ago } from "../../parts/words";
import { useScreen } from "../context";
import classes from "./inspector.module.css";

/** What reviewers said of this element, newest first. */
export function ReviewRemarks({ element }: { element: MapElement }) {
  const events = useScreen((state) => state.events);
  const now = useNow();
  const said = [...events]
    .sort((a, b) => new Date(b.at).getTime() - new Date(a.at).getTime())
    .flatMap((event) =>
      event.remarks
        .filter((remark) => remark.kind === element.kind && remark.element_id === element.id)
        .map((remark) => ({ event, remark })),
    );
  if (said.length === 0) return null;
  return (
    <section className={classes.remarks}>
      <h3 className="label">Review</h3>
      {said.map(({ event, remark }) => (
        <p key={event.at}>
          {remark.text}
          <br />
          <span className="third small">
            {event.actor.name} on revision {event.revision} · {ago(event.at, now)}
          </span>
        </p>
      ))}
    </section>
  );
}

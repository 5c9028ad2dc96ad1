import { useSearchParams } from "wouter";
import type { Revision, TaskEvent } from "../../../api/types";
import { useNow } from "../../parts/useNow";
import { ACTION_WORDS, ago, counted, KIND_WORDS } from "../../parts/words";
import { useScreen, useWorkspace } from "../context";
import classes from "./left.module.css";
import { ParkedDrafts } from "./ParkedDrafts";

type Entry = { at: string; revision: Revision } | { at: string; event: TaskEvent };

const actionWords = (action: string): string =>
  (ACTION_WORDS as Readonly<Record<string, string>>)[action] ?? action;

/** Saves and steps together, newest first. */
function timeline(revisions: readonly Revision[], events: readonly TaskEvent[]): Entry[] {
  const entries: Entry[] = [
    ...revisions.map((revision) => ({ at: revision.created_at, revision })),
    ...events.map((event) => ({ at: event.at, event })),
  ];
  return entries.sort((a, b) => new Date(b.at).getTime() - new Date(a.at).getTime());
}

export function HistoryTab() {
  const revisions = useScreen((state) => state.revisions);
  const events = useScreen((state) => state.events);
  return (
    <>
      <ParkedDrafts />
      <ol className={classes.history}>
        {timeline(revisions, events).map((entry) =>
          "revision" in entry ? (
            <RevisionEntry key={`revision ${entry.revision.number}`} revision={entry.revision} />
          ) : (
            <EventEntry key={`${entry.event.action} ${entry.at}`} event={entry.event} />
          ),
        )}
      </ol>
    </>
  );
}

function RevisionEntry({ revision }: { revision: Revision }) {
  const { workspace } = useWorkspace();
  const head = useScreen((state) => state.task.head);
  const now = useNow();
  const [parameters, setParameters] = useSearchParams();
  const shown =
    parameters.get("revision") === null ? revision.number === head : workspace.revision === revision.number;
  const open = () =>
    setParameters((before) => {
      const next = new URLSearchParams(before);
      if (revision.number === head) next.delete("revision");
      else next.set("revision", String(revision.number));
      return next;
    });
  return (
    <li>
      <button
        type="button"
        className={classes.historyEntry}
        data-shown={shown || undefined}
        aria-current={shown || undefined}
        onClick={open}
      >
        <strong>{revision.number === 0 ? "Imported map" : `Revision ${revision.number}`}</strong>
        <span className="second small">
          {revision.author?.name ?? "import"} · {ago(revision.created_at, now)}
          {revision.number > 0 && ` · ${counted(revision.changed_elements, "element")}`}
        </span>
        {revision.note !== "" && <span className="small">{revision.note}</span>}
      </button>
    </li>
  );
}

function EventEntry({ event }: { event: TaskEvent }) {
  const { editor, mapRef } = useWorkspace();
  const now = useNow();
  const visit = (remark: TaskEvent["remarks"][number]) => {
    const key = { kind: remark.kind, id: remark.element_id };
    editor.actions.select(key);
    mapRef.current?.fitElement(key);
  };
  return (
    <li className={classes.event} data-action={event.action}>
      <span>
        <strong>{event.actor.name}</strong> {actionWords(event.action)}{" "}
        <span className="second small">
          revision {event.revision} · {ago(event.at, now)}
        </span>
      </span>
      {event.reason !== "" && <p className={classes.reason}>{event.reason}</p>}
      {event.remarks.map((remark) => (
        <button
          key={`${remark.kind}:${remark.element_id}`}
          type="button"
          className={classes.remark}
          onClick={() => visit(remark)}
        >
          <span className="second">
            {KIND_WORDS[remark.kind]} {remark.element_id}:
          </span>{" "}
          {remark.text}
        </button>
      ))}
    </li>
  );
}

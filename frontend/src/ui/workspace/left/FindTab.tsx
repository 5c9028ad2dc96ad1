import { TextInput } from "@mantine/core";
import { IconSearch } from "@tabler/icons-react";
import { type SubmitEvent, useMemo, useState } from "react";
import type { ElementKey, MapDocument } from "../../../editor";
import { counted, KIND_WORDS } from "../../parts/words";
import { useEditor } from "../context";
import type { Commands } from "../useCommands";
import classes from "./left.module.css";

const MOST_SHOWN = 30;

/** Elements, of the imported map or the edited one, whose id holds the digits; a whole match comes first. */
export function findById(current: MapDocument, base: MapDocument, digits: string): ElementKey[] {
  if (digits === "") return [];
  const ids = (kind: ElementKey["kind"], maps: readonly ReadonlyMap<number, unknown>[]) =>
    [...new Set(maps.flatMap((map) => [...map.keys()]))]
      .filter((id) => String(id).includes(digits))
      .map((id) => ({ kind, id }));
  const found = [
    ...ids("lane_segment", [current.lanes, base.lanes]),
    ...ids("pedestrian_crossing", [current.crossings, base.crossings]),
  ];
  const rank = ({ id }: ElementKey) => (String(id) === digits ? 0 : String(id).startsWith(digits) ? 1 : 2);
  return found.sort((a, b) => rank(a) - rank(b) || a.id - b.id);
}

export function FindTab({ commands }: { commands: Commands }) {
  const [text, setText] = useState("");
  const current = useEditor((state) => state.current);
  const base = useEditor((state) => state.base);
  const digits = text.replaceAll(/\D/g, "");
  const found = useMemo(() => findById(current, base, digits), [current, base, digits]);
  const submit = (event: SubmitEvent) => {
    event.preventDefault();
    const [first] = found;
    if (first !== undefined) commands.visit(first);
  };
  return (
    <form onSubmit={submit} className={classes.find}>
      <TextInput
        aria-label="Id of a lane or crossing"
        placeholder="Id of a lane or crossing"
        leftSection={<IconSearch size={14} />}
        inputMode="numeric"
        autoFocus
        value={text}
        onChange={(event) => setText(event.currentTarget.value)}
      />
      <p className="third small" role="status">
        {digits === ""
          ? "Part of an id is enough; Enter goes to the first."
          : counted(found.length, "element")}
      </p>
      {found.slice(0, MOST_SHOWN).map((key) => (
        <button
          key={`${key.kind}:${key.id}`}
          type="button"
          className={classes.found}
          onClick={() => commands.visit(key)}
        >
          <span className="second">{KIND_WORDS[key.kind]}</span> <span className="mono">{key.id}</span>
          {!(key.kind === "lane_segment" ? current.lanes : current.crossings).has(key.id) && (
            <span className="third small"> deleted</span>
          )}
        </button>
      ))}
    </form>
  );
}

import { Button, Group, Modal, SegmentedControl, Stack } from "@mantine/core";
import { useState } from "react";
import type { ConflictingElement } from "../../api/types";
import { conflictKey, differingNames, isCut, type Side, settledEdits } from "../../work/settle";
import { counted, KIND_WORDS } from "../parts/words";
import { tellProblem } from "../shell/tell";
import { useEditor, useScreen, useWorkspace } from "./context";
import { attributeRows } from "./inspector/attributeRows";
import { useWork } from "./useFindings";
import classes from "./workspace.module.css";

const SIDES: { value: Side; label: string }[] = [
  { value: "mine", label: "Keep mine" },
  { value: "theirs", label: "Take theirs" },
];

/** Others saved what contradicts this draft: each element is settled, then editing goes on at the newer revision. */
export function StaleDialog() {
  const { work, editor, screen, reopen } = useWorkspace();
  const shown = useScreen((state) => state.staleShown);
  const seen = useEditor((state) => state.savedRevision);
  const stale = useWork((state) => state.stale);
  const [choices, setChoices] = useState<ReadonlyMap<string, Side>>(new Map());
  const [busy, setBusy] = useState(false);
  if (work === null || stale === null) return null;

  const edits = editor.actions.netEdits();
  const settle = () => {
    setBusy(true);
    work
      .rebase(stale, settledEdits(edits, stale.conflicts, choices))
      .then(reopen, tellProblem)
      .finally(() => setBusy(false));
  };
  const open = stale.conflicts.filter((conflict) => !choices.has(conflictKey(conflict))).length;
  return (
    <Modal
      opened={shown}
      onClose={() => screen.setState({ staleShown: false })}
      size="lg"
      title={`Revision ${stale.head} contradicts ${counted(stale.conflicts.length, "edit")}`}
    >
      <Stack gap={12}>
        <p className="second">
          Somebody saved revision {stale.head} while you worked from revision {seen}. Decide for each element;
          all your other edits stay.
        </p>
        <ul className={classes.conflicts}>
          {stale.conflicts.map((conflict) => (
            <li key={conflictKey(conflict)} className={classes.conflict}>
              <Conflict conflict={conflict} cut={isCut(edits, conflict)} />
              <SegmentedControl
                size="xs"
                aria-label={`${KIND_WORDS[conflict.kind]} ${conflict.id}`}
                data={SIDES}
                value={choices.get(conflictKey(conflict)) ?? ""}
                onChange={(side) => setChoices(new Map(choices).set(conflictKey(conflict), side as Side))}
              />
            </li>
          ))}
        </ul>
        <Group justify="flex-end" gap={8}>
          <Button variant="default" onClick={() => screen.setState({ staleShown: false })}>
            Later
          </Button>
          <Button disabled={open > 0} loading={busy} onClick={settle}>
            {open > 0 ? `${open} to decide` : `Go on at revision ${stale.head}`}
          </Button>
        </Group>
      </Stack>
    </Modal>
  );
}

const NEITHER_PAINT_NOR_TYPE: Readonly<Record<string, string>> = {
  left_lane_boundary: "left boundary moved",
  right_lane_boundary: "right boundary moved",
  edge1: "first edge moved",
  edge2: "second edge moved",
  successors: "links changed",
  predecessors: "links changed",
};

/** "deleted", or what was changed on it: "right mark none → dashed white, left boundary moved". */
function did(base: ConflictingElement["base"], version: ConflictingElement["base"]): string {
  if (version === null) return "deleted";
  if (base === null) return "inserted";
  const values = attributeRows({ old: base, new: version }).map(
    ({ name, before, after }) => `${name} ${before} → ${after}`,
  );
  const others = differingNames(base, version).flatMap((name) => NEITHER_PAINT_NOR_TYPE[name] ?? []);
  return [...values, ...new Set(others)].join(", ") || "neighbours changed";
}

function Conflict({ conflict, cut }: { conflict: ConflictingElement; cut: boolean }) {
  return (
    <div>
      <strong>
        {KIND_WORDS[conflict.kind]} <span className="mono">{conflict.id}</span>
      </strong>
      <p className="second small">You: {cut ? "cut" : did(conflict.base, conflict.mine)}</p>
      <p className="second small">They: {did(conflict.base, conflict.theirs)}</p>
    </div>
  );
}

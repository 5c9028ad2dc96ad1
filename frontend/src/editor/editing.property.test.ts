import fc from "fast-check";
import { expect, test } from "vitest";
import { applyChanges, differingKeys, elementOf, type MapDocument } from "./document";
import { changesOf, editsBetween } from "./edits";
import type { Line, LineName } from "./elements";
import { equalElements } from "./equality";
import { boundary, lineOf } from "./lines";
import { MARKS } from "./marks";
import { alongLine } from "./polyline";
import type { Editor } from "./state";
import { createEditor } from "./store";
import { brokenInvariants } from "./testInvariants";
import { idBlocks, wireMap, workspaceOf } from "./testRoad";

type Step = (editor: Editor) => unknown;

const pick = <T>(items: readonly T[], where: number): T | undefined =>
  items[Math.floor(where * items.length)];
const share = fc.double({ min: 0, max: 0.999, noNaN: true });
const shift = fc.double({ min: -4, max: 4, noNaN: true });
const side = fc.constantFrom("left" as const, "right" as const);

function someLane(editor: Editor, where: number) {
  return pick([...editor.getState().current.lanes.values()], where);
}

function someVertex(editor: Editor, where: number, name: "left" | "right", along: number) {
  const lane = someLane(editor, where);
  if (lane === undefined) return null;
  const line = boundary(lane, name);
  const index = Math.floor(along * line.length);
  return { vertex: { kind: "lane_segment", id: lane.id, side: name as LineName, index } as const, line };
}

const steps: fc.Arbitrary<{ name: string; run: Step }> = fc.oneof(
  fc.tuple(share, side, share, shift, shift).map(([where, name, along, dx, dy]) => ({
    name: `move ${where} ${name} ${along} ${dx} ${dy}`,
    run: (editor: Editor) => {
      const found = someVertex(editor, where, name, along);
      const point = found?.line[found.vertex.index];
      if (found && point) editor.actions.moveVertex(found.vertex, { x: point.x + dx, y: point.y + dy });
    },
  })),
  fc.tuple(share, side, share, fc.boolean()).map(([where, name, along, add]) => ({
    name: `${add ? "add" : "remove"} ${where} ${name} ${along}`,
    run: (editor: Editor) => {
      const found = someVertex(editor, where, name, along);
      if (found && add) editor.actions.addVertex(found.vertex);
      else if (found) editor.actions.removeVertex(found.vertex);
    },
  })),
  fc.tuple(share, shift, shift).map(([where, x, y]) => ({
    name: `shift ${where} ${x} ${y}`,
    run: (editor: Editor) => {
      const lane = someLane(editor, where);
      if (lane) editor.actions.moveElement({ kind: "lane_segment", id: lane.id }, { x, y });
    },
  })),
  fc.tuple(share, side, fc.constantFrom(...MARKS)).map(([where, name, mark]) => ({
    name: `mark ${where} ${name} ${mark}`,
    run: (editor: Editor) => {
      const lane = someLane(editor, where);
      if (lane) editor.actions.setMark(lane.id, name, mark);
    },
  })),
  fc.tuple(share, side).map(([where, name]) => ({
    name: `beside ${where} ${name}`,
    run: async (editor: Editor) => {
      const lane = someLane(editor, where);
      if (lane) await editor.actions.insertLaneBeside(lane.id, name);
    },
  })),
  fc.tuple(share, share).map(([where, along]) => ({
    name: `revert ${where} ${along}`,
    run: (editor: Editor) => {
      const { base, current } = editor.getState();
      const lane = pick([...base.lanes.values(), ...current.lanes.values()], where);
      if (lane) editor.actions.revertElement({ kind: "lane_segment", id: lane.id });
    },
  })),
  fc.tuple(share, share).map(([where, along]) => ({
    name: `cut ${where} ${along}`,
    run: async (editor: Editor) => {
      const lane = someLane(editor, where);
      const place = lane && alongLine(lane.left_lane_boundary, along);
      if (lane && place) await editor.actions.cutLane(lane.id, place, 0.5);
    },
  })),
  share.map((where) => ({
    name: `join ${where}`,
    run: (editor: Editor) => {
      const parts = [...editor.getState().current.lanes.values()].filter(({ part_of }) => part_of !== null);
      const lane = pick(parts, where);
      if (lane) editor.actions.joinLane(lane.id);
    },
  })),
  share.map((where) => ({
    name: `reverse ${where}`,
    run: (editor: Editor) => {
      const { base, current } = editor.getState();
      const lane = pick(
        [...current.lanes.values()].filter(({ id }) => !base.lanes.has(id)),
        where,
      );
      if (lane) editor.actions.reverseLane(lane.id);
    },
  })),
  share.map((where) => ({
    name: `delete ${where}`,
    run: (editor: Editor) => {
      const lane = someLane(editor, where);
      if (lane) editor.actions.deleteElement({ kind: "lane_segment", id: lane.id });
    },
  })),
  fc.constant({ name: "undo", run: (editor: Editor) => editor.actions.undo() }),
  fc.constant({ name: "redo", run: (editor: Editor) => editor.actions.redo() }),
  fc.constant({ name: "save", run: save }),
);

const NOTHING_ELSE = { declarations: [], canonical: [] };

/** A server that fills heights with 99 and stores the rest as sent. */
function save(editor: Editor): void {
  const snapshot = editor.actions.takeSnapshot();
  const { saved, savedRevision } = editor.getState();
  const filled = (line: Line) => line.map((point) => ({ ...point, z: point.z ?? 99 }));
  const changed = differingKeys(saved, snapshot.document);
  const lanes = changed.flatMap(({ kind, id }) => {
    const lane = kind === "lane_segment" ? snapshot.document.lanes.get(id) : undefined;
    if (lane === undefined) return [];
    const [left, right] = [filled(lane.left_lane_boundary), filled(lane.right_lane_boundary)];
    return [{ ...lane, left_lane_boundary: left, right_lane_boundary: right }];
  });
  const removed = changed.filter((key) => elementOf(snapshot.document, key) === null);
  editor.actions.adoptSaved(
    { revision: savedRevision + 1, changed: wireMap(lanes, []), removed, ...NOTHING_ELSE },
    snapshot,
  );
}

function sameMaps(a: MapDocument, b: MapDocument): boolean {
  return differingKeys(a, b).every((key) => equalElements(elementOf(a, key), elementOf(b, key)));
}

const sequences = fc.array(steps, { minLength: 1, maxLength: 14 });
const runs = { numRuns: Number(import.meta.env.VITE_PROPERTY_RUNS ?? 150) };

async function edited(sequence: readonly { run: Step }[]): Promise<Editor> {
  const editor = createEditor(workspaceOf(), idBlocks());
  for (const { run } of sequence) await run(editor);
  return editor;
}

test("lines that lanes share stay one line and links stay joined, whatever is done", async () => {
  await fc.assert(
    fc.asyncProperty(sequences, async (sequence) => {
      const { base, current } = (await edited(sequence)).getState();
      expect(brokenInvariants(base, current)).toEqual([]);
    }),
    runs,
  );
});

test("undoing everything gives the very same map, and redoing everything the edited one", async () => {
  await fc.assert(
    fc.asyncProperty(sequences, async (sequence) => {
      const editor = await edited(sequence.filter(({ name }) => name !== "save"));
      const { current, saved, history } = editor.getState();
      const steps = history.done.length;
      for (let i = 0; i < steps; i++) editor.actions.undo();
      expect(differingKeys(editor.getState().current, saved)).toEqual([]);
      for (let i = 0; i < steps; i++) editor.actions.redo();
      expect(differingKeys(editor.getState().current, current)).toEqual([]);
    }),
    runs,
  );
});

test("the net edits put onto the saved revision give the map on the screen", async () => {
  await fc.assert(
    fc.asyncProperty(sequences, async (sequence) => {
      const { saved, current } = (await edited(sequence)).getState();
      const edits = editsBetween(saved, current);
      const received = edits.map((edit) => ({ ...edit, attributes: { ...edit.attributes } }));
      const again = applyChanges(saved, changesOf(saved, received));
      expect(sameMaps(again, current)).toBe(true);
    }),
    runs,
  );
});

test("a vertex that no edit touched keeps every digit", async () => {
  await fc.assert(
    fc.asyncProperty(sequences, async (sequence) => {
      const { base, current } = (await edited(sequence.filter(({ name }) => name !== "save"))).getState();
      const imported = new Set(
        [...base.lanes.values()].flatMap((lane) =>
          [...lane.left_lane_boundary, ...lane.right_lane_boundary].map(({ x, y, z }) => `${x},${y},${z}`),
        ),
      );
      for (const [id, attributes] of current.lanes) {
        for (const name of ["left", "right"] as const) {
          for (const { x, y, z } of lineOf({ kind: "lane_segment", id, attributes }, name) ?? []) {
            const drawn =
              z === null &&
              Math.abs(x * 100 - Math.round(x * 100)) < 1e-6 &&
              Math.abs(y * 100 - Math.round(y * 100)) < 1e-6;
            expect(drawn || imported.has(`${x},${y},${z}`)).toBe(true);
          }
        }
      }
    }),
    runs,
  );
});

test("undo leads through a save back to the imported map", async () => {
  await fc.assert(
    fc.asyncProperty(sequences, sequences, async (before, after) => {
      const editor = await edited([...before, { run: save }, ...after]);
      while (editor.getState().history.done.length > 0) editor.actions.undo();
      const { base, current } = editor.getState();
      expect(sameMaps(base, current)).toBe(true);
    }),
    runs,
  );
});

import { Button } from "@mantine/core";
import { IconArrowsExchange, IconArrowsJoin2, IconCut, IconRestore, IconTrash } from "@tabler/icons-react";
import type { MapElement } from "../../../editor";
import { useEditor, useWorkspace } from "../context";
import classes from "./inspector.module.css";

interface ElementActionsProperties {
  element: MapElement;
  deleted: boolean;
  /** Whether it differs from the imported map. */
  changed: boolean;
}

export function ElementActions({ element, deleted, changed }: ElementActionsProperties) {
  const { actions } = useWorkspace().editor;
  const key = { kind: element.kind, id: element.id };
  return (
    <div className={classes.actions}>
      <Button
        variant="default"
        leftSection={<IconRestore size={15} aria-hidden />}
        disabled={!changed}
        title="The element as it was imported"
        onClick={() => actions.revertElement(key)}
      >
        {deleted ? "Bring it back" : "Revert"}
      </Button>
      <Button
        variant="default"
        leftSection={<IconTrash size={15} aria-hidden />}
        disabled={deleted}
        onClick={() => actions.deleteElement(key)}
      >
        Delete
      </Button>
      {element.kind === "lane_segment" && !deleted && <LaneActions id={element.id} />}
    </div>
  );
}

function LaneActions({ id }: { id: number }) {
  const { editor, mapRef } = useWorkspace();
  const imported = useEditor((state) => state.base.lanes.has(id));
  const part = useEditor((state) => (state.current.lanes.get(id)?.part_of ?? null) !== null);
  const cut = () => {
    editor.actions.setTool("cut");
    mapRef.current?.focus();
  };
  return (
    <>
      <Button
        variant="default"
        leftSection={<IconCut size={15} aria-hidden />}
        title="Where a mark, the type or the intersection changes half-way (X)"
        onClick={cut}
      >
        Cut
      </Button>
      {!imported && (
        <Button
          variant="default"
          leftSection={<IconArrowsJoin2 size={15} aria-hidden />}
          title="With the lane in series that it was cut from (C)"
          onClick={() => editor.actions.joinLane(id)}
        >
          Join
        </Button>
      )}
      {!imported && !part && (
        <Button
          variant="default"
          leftSection={<IconArrowsExchange size={15} aria-hidden />}
          title="Turn the lane round (V)"
          onClick={() => editor.actions.reverseLane(id)}
        >
          Reverse
        </Button>
      )}
    </>
  );
}

import { Button } from "@mantine/core";
import { IconRestore, IconTrash } from "@tabler/icons-react";
import type { MapElement } from "../../../editor";
import { useWorkspace } from "../context";
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
    </div>
  );
}

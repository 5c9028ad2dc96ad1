import { Checkbox, Select } from "@mantine/core";
import { type Lane, type LaneType, laneLength, laneWidth } from "../../../editor";
import { LANE_TYPE_WORDS } from "../../parts/words";
import { useWorkspace } from "../context";
import { Field } from "./Field";
import classes from "./inspector.module.css";
import { LaneLinks } from "./LaneLinks";
import { MarkPicker } from "./MarkPicker";
import { Measure } from "./Measure";

const TYPES = Object.entries(LANE_TYPE_WORDS).map(([value, label]) => ({ value, label }));

interface LaneInspectorProperties {
  lane: Lane;
  base: Lane | null;
  editable: boolean;
}

export function LaneInspector({ lane, base, editable }: LaneInspectorProperties) {
  const { editor } = useWorkspace();
  return (
    <>
      <div className={classes.fields}>
        <Field label="Type">
          {(id) => (
            <Select
              id={id}
              data={TYPES}
              value={lane.lane_type}
              allowDeselect={false}
              readOnly={!editable}
              onChange={(value) => value !== null && editor.actions.setLaneType(lane.id, value as LaneType)}
            />
          )}
        </Field>
        <Field label="Left mark">
          {(id) => <MarkPicker id={id} lane={lane} side="left" editable={editable} />}
        </Field>
        <Field label="Right mark">
          {(id) => <MarkPicker id={id} lane={lane} side="right" editable={editable} />}
        </Field>
        <Measure label="Width" metres={laneWidth(lane)} before={base === null ? null : laneWidth(base)} />
        <Measure label="Length" metres={laneLength(lane)} before={base === null ? null : laneLength(base)} />
        <Checkbox
          label="Inside an intersection"
          checked={lane.is_intersection}
          disabled={!editable}
          onChange={(event) => editor.actions.setIntersection(lane.id, event.currentTarget.checked)}
        />
      </div>
      <LaneLinks lane={lane} editable={editable} />
    </>
  );
}

import { Select } from "@mantine/core";
import { type Lane, MARKS, markOf, markWords, type Side } from "../../../editor";
import { MarkPaint } from "../../parts/MarkPaint";
import { useWorkspace } from "../context";
import classes from "./inspector.module.css";

const OPTIONS = MARKS.map((mark) => {
  const words = markWords(mark);
  return { value: mark, label: words.charAt(0).toUpperCase() + words.slice(1) };
});

interface MarkPickerProperties {
  id: string;
  lane: Lane;
  side: Side;
  editable: boolean;
}

/** The 15 legal marks, each shown as its paint. */
export function MarkPicker({ id, lane, side, editable }: MarkPickerProperties) {
  const { editor } = useWorkspace();
  const mark = markOf(lane, side);
  return (
    <Select
      id={id}
      data={OPTIONS}
      value={mark}
      allowDeselect={false}
      readOnly={!editable}
      withCheckIcon={false}
      maxDropdownHeight={420}
      comboboxProps={{ width: 250, position: "bottom-end" }}
      leftSection={<MarkPaint mark={mark} side={side} width={28} />}
      leftSectionWidth={37}
      rightSectionWidth={20}
      classNames={{ input: classes.markInput ?? "" }}
      leftSectionPointerEvents="none"
      renderOption={({ option }) => (
        <span className={classes.mark}>
          <MarkPaint mark={option.value} side={side} />
          {option.label}
        </span>
      )}
      onChange={(value) => value !== null && editor.actions.setMark(lane.id, side, value)}
    />
  );
}

import { Textarea } from "@mantine/core";
import type { MapElement } from "../../../editor";
import { useRemarks } from "../useRemarks";

/** A reviewer's remark on the element; it goes with the decision to send back. */
export function RemarkField({ element }: { element: MapElement }) {
  const { remarks, set } = useRemarks();
  const own = remarks.find((remark) => remark.kind === element.kind && remark.element_id === element.id);
  return (
    <Textarea
      label="Remark for the annotator"
      description="Goes along when you send the task back."
      autosize
      minRows={2}
      maxRows={8}
      value={own?.text ?? ""}
      onChange={(event) => set(element, event.currentTarget.value)}
    />
  );
}

import { Button } from "@mantine/core";
import { notifications } from "@mantine/notifications";
import type { Problem } from "../../api/problem";

/** A draft that changes nothing cannot be saved; it can be let go. */
export function tellDraftIsEmpty(problem: Problem, onDiscard: () => void): void {
  const id = problem.code;
  const discard = () => {
    notifications.hide(id);
    onDiscard();
  };
  notifications.show({
    id,
    color: "red",
    title: problem.message,
    message: (
      <>
        <p>{problem.mend}</p>
        <Button size="compact-xs" variant="default" mt={6} onClick={discard}>
          Discard draft
        </Button>
      </>
    ),
    autoClose: 20_000,
    closeButtonProps: { "aria-label": "Dismiss" },
  });
}

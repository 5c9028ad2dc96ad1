import { Button } from "@mantine/core";
import { useState } from "react";
import { counted } from "../parts/words";
import { Banner } from "./Banner";
import { useScreen, useWorkspace } from "./context";

/** Why the task came back: in view until the annotator has read it, and under History for good. */
export function SentBack() {
  const { screen } = useWorkspace();
  const state = useScreen(({ task }) => task.state);
  const events = useScreen((screenState) => screenState.events);
  const [read, setRead] = useState(false);
  const last = events.findLast((event) => event.to_state === "changes_requested");
  if (read || state !== "changes_requested" || last === undefined) return null;
  return (
    <Banner tone="warning">
      <span>
        <strong>{last.action === "reopen" ? "Reopened" : "Sent back"}</strong> by {last.actor.name}:{" "}
        {last.reason}
        {last.remarks.length > 0 && ` · ${counted(last.remarks.length, "remark")} beside the elements`}
      </span>
      <Button
        variant="default"
        onClick={() => {
          setRead(true);
          screen.setState({ tab: "history", leftShown: true });
        }}
      >
        Show the review
      </Button>
    </Banner>
  );
}

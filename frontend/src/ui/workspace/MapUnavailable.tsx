import { Button } from "@mantine/core";
import { EmptyState } from "../parts/EmptyState";

/** No map: the lists and the inspector go on working, and so does what is kept and saved. */
export function MapUnavailable({ reason, onRetry }: { reason: string; onRetry: () => void }) {
  return (
    <EmptyState title="The map cannot be shown">
      <p>{reason}</p>
      <p>Your edits are kept; lists, inspector and saving work without the map.</p>
      <Button variant="default" onClick={onRetry}>
        Try again
      </Button>
    </EmptyState>
  );
}

import { Button } from "@mantine/core";
import { Link } from "wouter";
import { EmptyState } from "../parts/EmptyState";

export function NothingToReview({ filtered, onClear }: { filtered: boolean; onClear: () => void }) {
  if (filtered) {
    return (
      <EmptyState title="Nothing that waits for review matches">
        <Button variant="default" onClick={onClear}>
          Clear the filter
        </Button>
      </EmptyState>
    );
  }
  return (
    <EmptyState title="Nothing waits for your review">
      <p>
        Submitted tasks appear here, oldest first; your own work goes to somebody else. See what is under way
        in <Link href="/tasks">all tasks</Link>.
      </p>
    </EmptyState>
  );
}

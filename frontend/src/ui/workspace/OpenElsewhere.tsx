import { Button, Group } from "@mantine/core";
import { Link } from "wouter";
import { EmptyState } from "../parts/EmptyState";

export function OpenElsewhere({ onTakeOver }: { onTakeOver: () => void }) {
  return (
    <EmptyState title="This task is open in another tab" page>
      <p>One tab edits it at a time. Its edits are kept; taking it over here goes on from the last one.</p>
      <Group gap={8}>
        <Button onClick={onTakeOver}>Edit here</Button>
        <Button component={Link} href="/" variant="default">
          My tasks
        </Button>
      </Group>
    </EmptyState>
  );
}

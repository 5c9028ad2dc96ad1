import { Button } from "@mantine/core";
import { Link } from "wouter";
import { EmptyState } from "../parts/EmptyState";

export function NotFoundPage() {
  return (
    <EmptyState title="There is no such page" page>
      <p>The address may be misspelt, or your role may not open it.</p>
      <Button component={Link} href="/" variant="default">
        My tasks
      </Button>
    </EmptyState>
  );
}

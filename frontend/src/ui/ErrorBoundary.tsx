import { Button, Group } from "@mantine/core";
import { Component, type ReactNode } from "react";
import { ProblemNotice } from "./parts/ProblemNotice";

/** A page that stumbles says so and offers a way on; work in progress is kept apart from the page, in drafts. */
export class ErrorBoundary extends Component<{ children: ReactNode }, { error: unknown }> {
  override state: { error: unknown } = { error: null };

  static getDerivedStateFromError(error: unknown) {
    return { error };
  }

  override render() {
    if (this.state.error === null) return this.props.children;
    return (
      <main className="centred">
        <h1>This page stumbled</h1>
        <ProblemNotice error={this.state.error} />
        <p className="second">
          Your edits are kept on this computer and come back when the task is opened again.
        </p>
        <Group gap={8}>
          <Button onClick={() => globalThis.location.reload()}>Reload the page</Button>
          <Button variant="default" component="a" href="/">
            My tasks
          </Button>
        </Group>
      </main>
    );
  }
}

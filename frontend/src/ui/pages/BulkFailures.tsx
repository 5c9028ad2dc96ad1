import { Alert } from "@mantine/core";
import type { BulkFailure } from "./useBulk";

interface BulkFailuresProperties<Item> {
  failures: readonly BulkFailure<Item>[];
  name: (item: Item) => string;
}

/** What of a bulk action failed, item by item; the rest is done. */
export function BulkFailures<Item>({ failures, name }: BulkFailuresProperties<Item>) {
  if (failures.length === 0) return null;
  return (
    <Alert color="red" title="These could not be done; the others are">
      <ul>
        {failures.map(({ item, message }) => (
          <li key={name(item)}>
            {name(item)}: {message}
          </li>
        ))}
      </ul>
    </Alert>
  );
}

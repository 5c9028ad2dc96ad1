import { useState } from "react";
import { asProblem } from "../../api/problem";

export interface BulkFailure<Item> {
  item: Item;
  message: string;
}

/** Does one thing to many items, one after the other; tells how far it is and what failed, item by item. */
export function useBulk<Item>(act: (item: Item) => Promise<unknown>) {
  const [done, setDone] = useState<number | null>(null);
  const [failures, setFailures] = useState<readonly BulkFailure<Item>[]>([]);
  const run = async (items: readonly Item[]): Promise<boolean> => {
    const failed: BulkFailure<Item>[] = [];
    setFailures([]);
    for (const [i, item] of items.entries()) {
      setDone(i);
      try {
        await act(item);
      } catch (error) {
        const problem = asProblem(error);
        failed.push({ item, message: `${problem.message} ${problem.mend}`.trim() });
      }
    }
    setDone(null);
    setFailures(failed);
    return failed.length === 0;
  };
  return { run, done, failures };
}

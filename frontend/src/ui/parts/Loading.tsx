import { Loader } from "@mantine/core";
import classes from "./parts.module.css";

/** Shows after 200 ms, so that a quick answer does not flash. */
export function Loading({ what }: { what: string }) {
  return (
    <div className={classes.loading} role="status">
      <Loader size={16} />
      Loading {what}…
    </div>
  );
}

import { useQuery } from "@tanstack/react-query";
import { Link, useRoute } from "wouter";
import { listTasks } from "../../api/tasks";
import { useRole } from "../useSession";
import classes from "./shell.module.css";

function Item({ to, label, count }: { to: string; label: string; count?: number | undefined }) {
  const [active] = useRoute(to);
  return (
    <Link
      href={to}
      className={classes.item}
      data-active={active || undefined}
      aria-current={active ? "page" : undefined}
    >
      <span>{label}</span>
      {count !== undefined && <span className={classes.count}>{count}</span>}
    </Link>
  );
}

/** Tasks that wait for the signed-in person; counted anew once a minute. */
function useCounts(oversees: boolean) {
  const mine = useQuery({
    queryKey: ["tasks", "count", "mine"],
    queryFn: () =>
      listTasks({ assignee: "me", state: ["draft", "changes_requested"], page_size: 1 }).then(
        (page) => page.total,
      ),
    refetchInterval: 60_000,
  });
  const review = useQuery({
    queryKey: ["tasks", "count", "review"],
    queryFn: () => listTasks({ reviewable: true, page_size: 1 }).then((page) => page.total),
    refetchInterval: 60_000,
    enabled: oversees,
  });
  return { mine: mine.data, review: review.data };
}

export function Navigation() {
  const role = useRole();
  const oversees = role !== "annotator";
  const { mine, review } = useCounts(oversees);
  return (
    <nav className={classes.navigation} aria-label="Pages">
      <Item to="/" label="My tasks" count={mine} />
      {oversees && <Item to="/review" label="Review queue" count={review} />}
      {oversees && (
        <>
          <span className={classes.group}>Dataset</span>
          <Item to="/tasks" label="All tasks" />
          <Item to="/logs" label="Logs" />
        </>
      )}
      <span className={classes.group}>Project</span>
      {role === "admin" && <Item to="/people" label="People" />}
      <Item to="/rules" label="Rules" />
      <Item to="/account" label="Your account" />
    </nav>
  );
}

import { lazy, Suspense } from "react";
import { Route, Switch } from "wouter";
import { AccountPage } from "./pages/AccountPage";
import { AllTasksPage } from "./pages/AllTasksPage";
import { LogsPage } from "./pages/LogsPage";
import { MyTasksPage } from "./pages/MyTasksPage";
import { NotFoundPage } from "./pages/NotFoundPage";
import { PeoplePage } from "./pages/PeoplePage";
import { Loading } from "./parts/Loading";
import { Shell } from "./shell/Shell";
import { useRole } from "./useSession";

// The map and its library are most of the app's size; pages without a map do not wait for them, nor for the rules.
const ReviewPage = lazy(() => import("./review/ReviewPage").then((page) => ({ default: page.ReviewPage })));
const RulePage = lazy(() => import("./rules/RulePage").then((page) => ({ default: page.RulePage })));
const TaskPage = lazy(() => import("./workspace/TaskPage").then((page) => ({ default: page.TaskPage })));

/** The pages by address; those that a role may not see are not found for it, as on the server. */
export function Routes() {
  const role = useRole();
  const oversees = role !== "annotator";
  return (
    <Switch>
      <Route path="/tasks/:task">
        {({ task }) => (
          <Suspense fallback={<Loading what="the map" />}>
            <TaskPage task={task} />
          </Suspense>
        )}
      </Route>
      <Route>
        <Shell>
          <Suspense fallback={<Loading what="the page" />}>
            <Switch>
              <Route path="/" component={MyTasksPage} />
              <Route path="/account" component={AccountPage} />
              <Route path="/rules">
                <RulePage />
              </Route>
              <Route path="/rules/:code">{({ code }) => <RulePage code={code} />}</Route>
              {oversees && <Route path="/tasks" component={AllTasksPage} />}
              {oversees && <Route path="/review" component={ReviewPage} />}
              {oversees && <Route path="/logs" component={LogsPage} />}
              {role === "admin" && <Route path="/people" component={PeoplePage} />}
              <Route component={NotFoundPage} />
            </Switch>
          </Suspense>
        </Shell>
      </Route>
    </Switch>
  );
}

import { Route, Switch } from "wouter";
import { AccountPage } from "./pages/AccountPage";
import { AllTasksPage } from "./pages/AllTasksPage";
import { LogsPage } from "./pages/LogsPage";
import { MyTasksPage } from "./pages/MyTasksPage";
import { NotFoundPage } from "./pages/NotFoundPage";
import { PeoplePage } from "./pages/PeoplePage";
import { ReviewPage } from "./review/ReviewPage";
import { Shell } from "./shell/Shell";
import { useRole } from "./useSession";
import { TaskPage } from "./workspace/TaskPage";

/** The pages by address; those that a role may not see are not found for it, as on the server. */
export function Routes() {
  const role = useRole();
  const oversees = role !== "annotator";
  return (
    <Switch>
      <Route path="/tasks/:task">{({ task }) => <TaskPage task={task} />}</Route>
      <Route>
        <Shell>
          <Switch>
            <Route path="/" component={MyTasksPage} />
            <Route path="/account" component={AccountPage} />
            {oversees && <Route path="/tasks" component={AllTasksPage} />}
            {oversees && <Route path="/review" component={ReviewPage} />}
            {oversees && <Route path="/logs" component={LogsPage} />}
            {role === "admin" && <Route path="/people" component={PeoplePage} />}
            <Route component={NotFoundPage} />
          </Switch>
        </Shell>
      </Route>
    </Switch>
  );
}

import { useEffect, useState } from "react";
import { useStore } from "zustand";
import { loadSession } from "../api/session";
import { sessionStore } from "../api/sessionStore";
import { ErrorBoundary } from "./ErrorBoundary";
import { Loading } from "./parts/Loading";
import { ProblemNotice } from "./parts/ProblemNotice";
import { Queries } from "./Queries";
import { Routes } from "./Routes";
import { SignInDialog } from "./signin/SignInDialog";
import { SignInPage } from "./signin/SignInPage";
import { SessionContext } from "./useSession";

export function App() {
  const session = useStore(sessionStore, (state) => state.session);
  const [failure, setFailure] = useState<unknown>(null);

  useEffect(() => {
    loadSession().catch(setFailure);
  }, []);
  const retry = () => {
    setFailure(null);
    loadSession().catch(setFailure);
  };

  if (failure !== null) {
    return (
      <main className="centred">
        <ProblemNotice error={failure} onRetry={retry} />
      </main>
    );
  }
  if (session === undefined) return <Loading what="Lanewright" />;
  if (session === null) return <SignInPage />;
  return (
    <SessionContext value={session}>
      <ErrorBoundary>
        <Queries key={session.account.id}>
          <Routes />
        </Queries>
      </ErrorBoundary>
      <SignInDialog name={session.account.name} />
    </SessionContext>
  );
}

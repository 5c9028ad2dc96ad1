import { useQueryClient } from "@tanstack/react-query";
import { useEffect, useRef, useState } from "react";
import { useStore } from "zustand";
import { loadSession } from "../api/session";
import { sessionStore } from "../api/sessionStore";
import { ErrorBoundary } from "./ErrorBoundary";
import { Loading } from "./parts/Loading";
import { ProblemNotice } from "./parts/ProblemNotice";
import { Routes } from "./Routes";
import { SignInDialog } from "./signin/SignInDialog";
import { SignInPage } from "./signin/SignInPage";
import { SessionContext } from "./useSession";

export function App() {
  const session = useStore(sessionStore, (state) => state.session);
  const queryClient = useQueryClient();
  const [failure, setFailure] = useState<unknown>(null);
  const account = session?.account.id;
  const shown = useRef(account);

  useEffect(() => {
    loadSession().catch(setFailure);
  }, []);
  const retry = () => {
    setFailure(null);
    loadSession().catch(setFailure);
  };

  // What was loaded for one account is not shown to the next.
  useEffect(() => {
    if (shown.current !== account) queryClient.clear();
    shown.current = account;
  }, [account, queryClient]);

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
        <Routes key={session.account.id} />
      </ErrorBoundary>
      <SignInDialog name={session.account.name} />
    </SessionContext>
  );
}

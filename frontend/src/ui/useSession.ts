import { createContext, useContext } from "react";
import type { Role, Session } from "../api/types";

export const SessionContext = createContext<Session | null>(null);

/** Who is signed in; only for what is shown to signed-in people. */
export function useSession(): Session {
  const session = useContext(SessionContext);
  if (session === null) throw new Error("shown outside of a session");
  return session;
}

export function useRole(): Role {
  return useSession().account.role;
}

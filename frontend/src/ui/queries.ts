import { QueryClient } from "@tanstack/react-query";
import { Problem } from "../api/problem";
import { sessionStore } from "../api/sessionStore";

/** Asked again by itself only when the same request may succeed without anybody changing anything. */
const mayPass = (failures: number, error: Error) => failures < 2 && error instanceof Problem && error.passing;

export const queries = new QueryClient({
  defaultOptions: { queries: { retry: mayPass, staleTime: 5_000 }, mutations: { retry: false } },
});

// What was loaded for one account is not shown to the next. Not in an effect: those of the pages that ask anew run
// first, and would be left waiting for what is cleared.
sessionStore.subscribe((state, before) => {
  if (state.session?.account.id !== before.session?.account.id) queries.clear();
});

import { QueryClient } from "@tanstack/react-query";
import { Problem } from "../api/problem";

/** Asked again by itself only when the same request may succeed without anybody changing anything. */
const mayPass = (failures: number, error: Error) => failures < 2 && error instanceof Problem && error.passing;

export const queries = new QueryClient({
  defaultOptions: { queries: { retry: mayPass, staleTime: 5_000 }, mutations: { retry: false } },
});

import { QueryClient, QueryClientProvider } from "@tanstack/react-query";
import { type ReactNode, useState } from "react";
import { Problem } from "../api/problem";

/** Asked again by itself only when the same request may succeed without anybody changing anything. */
const mayPass = (failures: number, error: Error) => failures < 2 && error instanceof Problem && error.passing;

const newClient = () =>
  new QueryClient({
    defaultOptions: { queries: { retry: mayPass, staleTime: 5_000 }, mutations: { retry: false } },
  });

/** What was loaded, for one account: the next one who signs in starts with nothing of it. */
export function Queries({ children }: { children: ReactNode }) {
  const [client] = useState(newClient);
  return <QueryClientProvider client={client}>{children}</QueryClientProvider>;
}

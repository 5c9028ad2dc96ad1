import { ask, client } from "./client";
import type { LogPage } from "./types";

export interface LogFilter {
  q?: string;
  city?: string;
  split?: string;
  page?: number;
  page_size?: number;
}

export const listLogs = (query: LogFilter): Promise<LogPage> =>
  ask(() => client.GET("/api/v1/logs", { params: { query } }));

import { ask, client } from "./client";
import type { Token, TokenCreated } from "./types";

export const listTokens = (): Promise<Token[]> => ask(() => client.GET("/api/v1/tokens"));

export const createToken = (body: { name: string; scopes: string[]; days: number }): Promise<TokenCreated> =>
  ask(() => client.POST("/api/v1/tokens", { body }));

export const revokeToken = (id: number): Promise<unknown> =>
  ask(() => client.DELETE("/api/v1/tokens/{token_id}", { params: { path: { token_id: id } } }));

import { ask, client } from "./client";
import type { Account, Person, Role } from "./types";

export const listAccounts = (): Promise<Account[]> => ask(() => client.GET("/api/v1/accounts"));

export const listPeople = (): Promise<Person[]> => ask(() => client.GET("/api/v1/people"));

export const createAccount = (body: { name: string; role: Role; password: string }): Promise<Account> =>
  ask(() => client.POST("/api/v1/accounts", { body }));

/** What an admin changes; left out means unchanged. */
export interface AccountChange {
  role?: Role;
  disabled?: boolean;
  password?: string;
}

export const changeAccount = (id: number, body: AccountChange): Promise<Account> =>
  ask(() => client.PATCH("/api/v1/accounts/{account_id}", { params: { path: { account_id: id } }, body }));

import { Button } from "@mantine/core";
import { useQuery, useQueryClient } from "@tanstack/react-query";
import { useState } from "react";
import { listAccounts } from "../../api/accounts";
import type { Account } from "../../api/types";
import { Loading } from "../parts/Loading";
import { ProblemNotice } from "../parts/ProblemNotice";
import { AddPersonDialog } from "./AddPersonDialog";
import { PageHead } from "./PageHead";
import { PersonRow } from "./PersonRow";
import classes from "./pages.module.css";
import { ResetPasswordDialog } from "./ResetPasswordDialog";

export function PeoplePage() {
  const queryClient = useQueryClient();
  const accounts = useQuery({ queryKey: ["accounts"], queryFn: listAccounts });
  const [adding, setAdding] = useState(false);
  const [resetting, setResetting] = useState<Account | null>(null);
  const renew = () => {
    void queryClient.invalidateQueries({ queryKey: ["accounts"] });
    void queryClient.invalidateQueries({ queryKey: ["people"] });
  };
  return (
    <div className={classes.page}>
      <PageHead title="People" subtitle="Who may sign in, and what they may do.">
        <Button onClick={() => setAdding(true)}>Add a person</Button>
      </PageHead>
      {accounts.isPending && <Loading what="people" />}
      {accounts.isError && <ProblemNotice error={accounts.error} onRetry={() => void accounts.refetch()} />}
      {accounts.data && (
        <table className={classes.table}>
          <thead>
            <tr>
              <th>Name</th>
              <th>Role</th>
              <th>Since</th>
              <th>State</th>
              <th>
                <span className="visually-hidden">Actions</span>
              </th>
            </tr>
          </thead>
          <tbody>
            {accounts.data.map((account) => (
              <PersonRow key={account.id} account={account} onChanged={renew} onReset={setResetting} />
            ))}
          </tbody>
        </table>
      )}
      {adding && (
        <AddPersonDialog
          onClose={() => setAdding(false)}
          onAdded={() => {
            setAdding(false);
            renew();
          }}
        />
      )}
      {resetting !== null && <ResetPasswordDialog account={resetting} onClose={() => setResetting(null)} />}
    </div>
  );
}

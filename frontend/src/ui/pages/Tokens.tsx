import { useQuery, useQueryClient } from "@tanstack/react-query";
import { useState } from "react";
import { listTokens } from "../../api/tokens";
import type { TokenCreated } from "../../api/types";
import { Loading } from "../parts/Loading";
import { ProblemNotice } from "../parts/ProblemNotice";
import { NewToken } from "./NewToken";
import { NewTokenSecret } from "./NewTokenSecret";
import classes from "./pages.module.css";
import { TokenRow } from "./TokenRow";

export function Tokens() {
  const queryClient = useQueryClient();
  const tokens = useQuery({ queryKey: ["tokens"], queryFn: listTokens });
  const [created, setCreated] = useState<TokenCreated | null>(null);
  const renew = () => void queryClient.invalidateQueries({ queryKey: ["tokens"] });
  return (
    <section className={classes.card} aria-label="API tokens">
      <h2>API tokens</h2>
      <p className="second">
        Let a program read the dataset in your name, limited to what you tick, until the day it expires.
      </p>
      <NewToken
        onCreated={(token) => {
          setCreated(token);
          renew();
        }}
      />
      {created !== null && <NewTokenSecret token={created} onDone={() => setCreated(null)} />}
      {tokens.isPending && <Loading what="tokens" />}
      {tokens.isError && <ProblemNotice error={tokens.error} onRetry={() => void tokens.refetch()} />}
      {tokens.data && tokens.data.length > 0 && (
        <table className={classes.table}>
          <thead>
            <tr>
              <th>Name</th>
              <th>May</th>
              <th>Expires</th>
              <th>Last used</th>
              <th>
                <span className="visually-hidden">Actions</span>
              </th>
            </tr>
          </thead>
          <tbody>
            {tokens.data.map((token) => (
              <TokenRow key={token.id} token={token} onRevoked={renew} />
            ))}
          </tbody>
        </table>
      )}
      {tokens.data?.length === 0 && <p className="third">You have no token yet. Create one above.</p>}
    </section>
  );
}

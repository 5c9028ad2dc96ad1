import { Button } from "@mantine/core";
import { useState } from "react";
import { revokeToken } from "../../api/tokens";
import type { Token } from "../../api/types";
import { useNow } from "../parts/useNow";
import { ago, day } from "../parts/words";
import { tellProblem } from "../shell/tell";
import { scopeWords } from "./scopes";

export function TokenRow({ token, onRevoked }: { token: Token; onRevoked: () => void }) {
  const now = useNow();
  const [busy, setBusy] = useState(false);
  const expired = new Date(token.expires_at).getTime() <= now;
  const revoke = () => {
    setBusy(true);
    revokeToken(token.id)
      .then(onRevoked, tellProblem)
      .finally(() => setBusy(false));
  };
  return (
    <tr>
      <td>{token.name}</td>
      <td>{scopeWords(token.scopes)}</td>
      <td>{expired ? "expired" : day(token.expires_at)}</td>
      <td>{token.last_used_at === null ? "never" : ago(token.last_used_at, now)}</td>
      <td>
        {token.revoked_at !== null ? (
          <span className="third">revoked</span>
        ) : (
          <Button variant="default" color="red" loading={busy} onClick={revoke}>
            Revoke
          </Button>
        )}
      </td>
    </tr>
  );
}

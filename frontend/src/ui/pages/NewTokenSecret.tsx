import { Alert, Button, CopyButton, Group, Stack } from "@mantine/core";
import type { TokenCreated } from "../../api/types";
import classes from "./pages.module.css";

/** The one time that a token is shown. */
export function NewTokenSecret({ token, onDone }: { token: TokenCreated; onDone: () => void }) {
  const example = `curl -H "Authorization: Bearer ${token.token}" \\\n  ${globalThis.location.origin}/api/v1/export/train.tar | tar x`;
  return (
    <Alert color="green" title={`Token “${token.name}”: copy it now, it is not shown again`}>
      <Stack gap={8}>
        <code className={classes.code}>{token.token}</code>
        {token.scopes.includes("export:read") && (
          <>
            <span className="second">For example, the accepted maps of the training split:</span>
            <code className={classes.code}>{example}</code>
          </>
        )}
        <Group gap={8}>
          <CopyButton value={token.token}>
            {({ copied, copy }) => <Button onClick={copy}>{copied ? "Copied" : "Copy the token"}</Button>}
          </CopyButton>
          <Button variant="default" onClick={onDone}>
            Done
          </Button>
        </Group>
      </Stack>
    </Alert>
  );
}

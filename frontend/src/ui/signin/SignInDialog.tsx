import { Modal, Stack } from "@mantine/core";
import { useStore } from "zustand";
import { answerSignIn, sessionStore } from "../../api/sessionStore";
import { SignInForm } from "./SignInForm";

/** Signing in again over the page that was open; what waited for it then goes on. */
export function SignInDialog({ name }: { name: string }) {
  const asking = useStore(sessionStore, (state) => state.asking);
  return (
    <Modal opened={asking} onClose={() => answerSignIn(null)} title="Sign in again" zIndex={400} size={380}>
      <Stack gap={12}>
        <p className="second">
          Your session has ended. Nothing is lost: what you were doing goes on after you sign in.
        </p>
        <SignInForm initialName={name} onSignedIn={answerSignIn} />
      </Stack>
    </Modal>
  );
}

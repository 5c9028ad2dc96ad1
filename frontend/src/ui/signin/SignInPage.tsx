import { useStore } from "zustand";
import { sessionStore } from "../../api/sessionStore";
import { DemoSignIns } from "./DemoSignIns";
import { SignInForm } from "./SignInForm";
import classes from "./signin.module.css";

export function SignInPage() {
  const demo = useStore(sessionStore, (state) => state.demo);
  const enter = (session: NonNullable<ReturnType<typeof sessionStore.getState>["session"]>) =>
    sessionStore.setState({ session });
  return (
    <main className={classes.page}>
      <div className={classes.card}>
        <img src="/favicon.svg" width={36} height={36} alt="" />
        <h1>Lanewright</h1>
        <p className="second">Annotation of changes in HD maps.</p>
        <SignInForm onSignedIn={enter} />
        {demo && <DemoSignIns onSignedIn={enter} />}
      </div>
    </main>
  );
}

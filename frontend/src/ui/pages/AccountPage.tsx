import { useSession } from "../useSession";
import { OwnPassword } from "./OwnPassword";
import { PageHead } from "./PageHead";
import classes from "./pages.module.css";
import { Tokens } from "./Tokens";

export function AccountPage() {
  const { account } = useSession();
  return (
    <div className={`${classes.page ?? ""} ${classes.narrow ?? ""}`}>
      <PageHead title="Your account" subtitle={`${account.name} · ${account.role}`} />
      <OwnPassword />
      {account.role !== "annotator" && <Tokens />}
    </div>
  );
}

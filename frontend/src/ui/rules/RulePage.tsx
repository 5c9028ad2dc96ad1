import { Link } from "wouter";
import { PageHead } from "../pages/PageHead";
import pages from "../pages/pages.module.css";

import { RuleText } from "./RuleText";
import { ruleTitle } from "./ruleTitle";

/** A rule's page; without a code, the list of all rules. */
export function RulePage({ code = null }: { code?: string | null }) {
  if (code === null) {
    return (
      <div className={pages.page}>
        <PageHead title="Rules" subtitle="One map update, one explanation: what a save must not contain." />
        <RuleText code={null} />
      </div>
    );
  }
  return (
    <div className={`${pages.page} ${pages.narrow}`}>
      <PageHead title={ruleTitle(code)} subtitle={<span className="mono">{code}</span>}>
        <Link href="/rules">All rules</Link>
      </PageHead>
      <RuleText code={code} />
    </div>
  );
}

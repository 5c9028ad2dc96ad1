import { Button } from "@mantine/core";
import { useState } from "react";
import type { Violation } from "../../../api/types";
import { Loading } from "../../parts/Loading";
import { ProblemNotice } from "../../parts/ProblemNotice";
import { counted } from "../../parts/words";
import { useWorkspace } from "../context";
import type { Commands } from "../useCommands";
import { useFindings } from "../useFindings";
import { Issue } from "./Issue";
import classes from "./left.module.css";

/** Errors first: they stop the save. */
function ordered(violations: readonly Violation[]): Violation[] {
  return [...violations].sort((a, b) => Number(b.blocks) - Number(a.blocks));
}

export function IssuesTab({ commands }: { commands: Commands }) {
  const { work } = useWorkspace();
  const { findings, problem } = useFindings();
  const [inheritedShown, setInheritedShown] = useState(false);
  if (problem !== null) return <ProblemNotice error={problem} />;
  if (findings === null) return <Loading what="issues" />;
  const own = ordered(findings.violations.filter((violation) => !violation.inherited));
  const inherited = findings.violations.filter((violation) => violation.inherited);
  const first = own.find((violation) => violation.fixes.length > 0);
  return (
    <div className={classes.issues}>
      {own.length === 0 && (
        <p className={classes.nothing}>
          No issue.{" "}
          {work !== null && "Every edit is checked as you make it; what is wrong appears here with its mend."}
        </p>
      )}
      {own.map((violation) => (
        <Issue
          key={violation.id}
          violation={violation}
          commands={commands}
          editable={work !== null}
          first={violation === first}
        />
      ))}
      {inherited.length > 0 && (
        <>
          <Button
            variant="subtle"
            onClick={() => setInheritedShown(!inheritedShown)}
            aria-expanded={inheritedShown}
          >
            {inheritedShown ? "Hide" : "Show"} {counted(inherited.length, "defect")} of the imported map
          </Button>
          {inheritedShown &&
            inherited.map((violation) => (
              <Issue
                key={violation.id}
                violation={violation}
                commands={commands}
                editable={false}
                first={false}
              />
            ))}
        </>
      )}
    </div>
  );
}

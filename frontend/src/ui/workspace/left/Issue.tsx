import { Button } from "@mantine/core";
import { IconAlertTriangle, IconCircleX, IconInfoCircle } from "@tabler/icons-react";
import type { MouseEvent } from "react";
import type { Violation } from "../../../api/types";
import { KIND_WORDS } from "../../parts/words";
import { ruleTitle } from "../../rules/ruleTitle";
import { useWorkspace } from "../context";
import type { Commands } from "../useCommands";
import classes from "./left.module.css";

const ICONS = { error: IconCircleX, warning: IconAlertTriangle, none: IconInfoCircle };

interface IssueProperties {
  violation: Violation;
  commands: Commands;
  editable: boolean;
  /** The one whose fix Enter applies. */
  first: boolean;
}

/** What happened, why it is wrong, and the mend as a button. */
export function Issue({ violation, commands, editable, first }: IssueProperties) {
  const { editor, screen } = useWorkspace();
  const { code, kind, elements, severity, inherited } = violation;
  const tone = inherited ? "inherited" : severity;
  const Icon = ICONS[severity];
  const hover = (id: number | undefined) => editor.actions.hover(id === undefined ? null : { kind, id });
  /** Beside the map; with Ctrl in a tab, as any link. */
  const readRule = (event: MouseEvent) => {
    if (event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    screen.setState({ rule: code });
  };
  return (
    <article
      className={classes.issue}
      data-tone={tone}
      onMouseEnter={() => hover(elements[0])}
      onMouseLeave={() => hover(undefined)}
    >
      <h3 className={classes.issueTitle}>
        <Icon size={15} aria-hidden />
        {ruleTitle(code)}
        <span className="visually-hidden">({severity === "none" ? "note" : severity})</span>
      </h3>
      <p>{violation.message}</p>
      <p className={classes.issueElements}>
        {elements.map((id) => (
          <button
            key={id}
            type="button"
            className={classes.link}
            onClick={() => commands.visit({ kind, id })}
          >
            {KIND_WORDS[kind]} {id}
          </button>
        ))}
        <a className={classes.rule} href={`/rules/${code}`} onClick={readRule}>
          Why? <span className="mono">{code}</span>
        </a>
      </p>
      {editable && violation.fixes.length > 0 && (
        <div className={classes.fixes}>
          {violation.fixes.map((fix, index) => (
            <Button
              key={fix.title}
              variant="default"
              h="auto"
              mih={28}
              py={4}
              justify="space-between"
              styles={{ label: { whiteSpace: "normal", lineHeight: 1.4, textAlign: "left" } }}
              rightSection={first && index === 0 ? <kbd>Enter</kbd> : undefined}
              onClick={() => commands.applyFix(violation, index)}
            >
              {fix.title}
            </Button>
          ))}
        </div>
      )}
    </article>
  );
}

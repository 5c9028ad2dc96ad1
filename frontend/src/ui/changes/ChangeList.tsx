import { type ReactNode, useMemo } from "react";
import type { Change, ElementKey, Findings } from "../../api/types";
import { CategoryMark } from "../parts/CategoryMark";
import classes from "./changes.module.css";
import { type ChangeGroup, groupChanges } from "./grouping";
import { MacroChips } from "./MacroChips";

interface ChangeListProperties {
  findings: Findings;
  selected?: ElementKey | null;
  hovered?: ElementKey | null;
  onSelect?: (key: ElementKey) => void;
  onHover?: (key: ElementKey | null) => void;
  /** What stands beside a group's macros. */
  besideMacros?: (group: ChangeGroup) => ReactNode;
}

const same = (a: ElementKey | null | undefined, b: ElementKey) => a?.kind === b.kind && a.id === b.id;

/** What changed, told by structural update; in step with the map by selection and hover. */
export function ChangeList(properties: ChangeListProperties) {
  const { findings, selected, hovered, onSelect, onHover, besideMacros } = properties;
  const groups = useMemo(() => groupChanges(findings), [findings]);
  return (
    <div className={classes.list}>
      {groups.map((group) => (
        <section key={group.key} aria-label={group.title}>
          <header className={classes.groupHead}>
            <h3 className={classes.groupTitle}>{group.title}</h3>
            <span className={classes.groupCount}>{group.changes.length}</span>
          </header>
          {group.macros !== null && (
            <div className={classes.macros}>
              <MacroChips macros={group.macros} />
              {besideMacros?.(group)}
            </div>
          )}
          {group.changes.map((change) => (
            <ChangeRow
              key={`${change.kind}:${change.id}`}
              change={change}
              selected={same(selected, change)}
              hovered={same(hovered, change)}
              onSelect={onSelect}
              onHover={onHover}
            />
          ))}
        </section>
      ))}
    </div>
  );
}

interface ChangeRowProperties {
  change: Change;
  selected: boolean;
  hovered: boolean;
  onSelect: ((key: ElementKey) => void) | undefined;
  onHover: ((key: ElementKey | null) => void) | undefined;
}

function ChangeRow({ change, selected, hovered, onSelect, onHover }: ChangeRowProperties) {
  const key = { kind: change.kind, id: change.id };
  return (
    <button
      type="button"
      className={classes.change}
      data-selected={selected || undefined}
      data-hovered={hovered || undefined}
      aria-current={selected || undefined}
      onClick={() => onSelect?.(key)}
      onMouseEnter={() => onHover?.(key)}
      onMouseLeave={() => onHover?.(null)}
      onFocus={() => onHover?.(key)}
      onBlur={() => onHover?.(null)}
    >
      <CategoryMark categories={change.categories} />
      <span className={classes.words}>
        <span className={classes.headline}>{change.headline}</span>
        {change.detail !== "" && <span className={classes.detail}>{change.detail}</span>}
        {change.exported_as !== "" && <span className={classes.exported}>{change.exported_as}</span>}
      </span>
    </button>
  );
}

import { Button } from "@mantine/core";
import { IconWand } from "@tabler/icons-react";
import { declarationOf } from "../../../editor";
import { ChangeList } from "../../changes/ChangeList";
import type { ChangeGroup } from "../../changes/grouping";
import { Loading } from "../../parts/Loading";
import { ProblemNotice } from "../../parts/ProblemNotice";
import { useEditor, useScreen, useWorkspace } from "../context";
import type { Commands } from "../useCommands";
import { useFindings } from "../useFindings";
import { Declare } from "./Declare";
import classes from "./left.module.css";

/** The session so far, in words: everything that differs from the imported map. */
export function ChangesTab({ commands }: { commands: Commands }) {
  const { editor, work } = useWorkspace();
  const { findings, checking, problem } = useFindings();
  const selected = useEditor((state) => state.selection);
  const hovered = useEditor((state) => state.hover);
  const declarations = useEditor((state) => state.declarations);
  const canonicalising = useScreen((state) => state.canonicalising);
  if (problem !== null) return <ProblemNotice error={problem} />;
  if (findings === null) return <Loading what="changes" />;
  if (findings.changes.length === 0) {
    return (
      <p className={classes.nothing}>
        {work === null
          ? "Nothing was changed: prior and current map are the same."
          : "Nothing is changed yet. Select a lane or crossing on the map and edit it, or draw a new one with the tools at the left."}
      </p>
    );
  }
  const declare = ({ macros, elements }: ChangeGroup) =>
    macros !== null && (
      <Declare
        derived={macros}
        declared={declarationOf(declarations, elements)}
        editable={work !== null}
        onDeclare={(stated) => editor.actions.declare(elements, stated)}
      />
    );
  return (
    <div aria-busy={checking}>
      <ChangeList
        findings={findings}
        selected={selected}
        hovered={hovered}
        onSelect={commands.visit}
        onHover={(key) => editor.actions.hover(key)}
        besideMacros={declare}
      />
      {work !== null && (
        <Button
          variant="default"
          fullWidth
          mt={20}
          leftSection={<IconWand size={15} aria-hidden />}
          rightSection={<kbd>M</kbd>}
          title="The same map, told with the fewest changes; lanes and crossings may get other ids"
          loading={canonicalising}
          onClick={commands.makeCanonical}
        >
          Make canonical
        </Button>
      )}
    </div>
  );
}

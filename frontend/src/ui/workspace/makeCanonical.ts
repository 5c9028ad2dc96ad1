import { canonicalForm } from "../../api/workspace";
import { elementOf, keyText } from "../../editor";
import { canonicalWords } from "../../work/canonicalWords";
import { tell } from "../shell/tell";
import type { WorkspaceValue } from "./context";

/** Brings the draft into its canonical form, as one undo step, and says in words what that did. */
export async function makeCanonical(value: WorkspaceValue): Promise<void> {
  const { screen } = value;
  if (screen.getState().canonicalising) return;
  screen.setState({ canonicalising: true });
  try {
    await bringIntoForm(value);
  } finally {
    screen.setState({ canonicalising: false });
  }
}

async function bringIntoForm({ editor, workspace }: WorkspaceValue): Promise<void> {
  const { base, current, savedRevision, declarations } = editor.getState();
  const { edits } = editor.actions.netDraft();
  const body = { base_revision: savedRevision, edits, declarations: [...declarations] };
  const form = await canonicalForm(workspace.task.id, body);
  if (form.edits.length === 0) {
    tell("Already canonical: no other ids tell this with fewer changes.");
    return;
  }
  const now = editor.getState();
  if (now.current !== current || now.declarations !== declarations) {
    tell("The map was edited meanwhile. Make it canonical again.");
    return;
  }
  const renamed = new Map(form.renamed.map(({ kind, from, to }) => [keyText({ kind, id: from }), to]));
  const called = <Key extends Parameters<typeof keyText>[0]>(key: Key): Key => {
    const to = renamed.get(keyText(key));
    return to !== undefined && elementOf(base, { kind: key.kind, id: to }) !== null
      ? { ...key, id: to }
      : key;
  };
  const stated = declarations.map((one) => ({ ...one, elements: one.elements.map(called) }));
  const { selection } = editor.getState();
  const done = await editor.actions.applyFix(form.edits, "Made canonical", stated);
  if (!done.ok) return;
  // What was selected may be a part of another lane now.
  const follows = selection && called(selection);
  if (follows && elementOf(editor.getState().current, follows) !== null)
    editor.actions.select(follows, selection);
  tell(canonicalWords(form, (key) => elementOf(base, key) !== null));
}

/** Hands a kept draft to the user as a file. */
export function downloadDraft(
  task: number,
  draft: { baseRevision: number; edits: readonly unknown[]; declarations?: readonly unknown[] | null },
): void {
  const { baseRevision, edits, declarations = null } = draft;
  const body = {
    task,
    base_revision: baseRevision,
    edits,
    ...(declarations === null ? {} : { declarations }),
  };
  const url = URL.createObjectURL(new Blob([JSON.stringify(body, null, 1)], { type: "application/json" }));
  const link = document.createElement("a");
  link.href = url;
  link.download = `task-${task}-draft.json`;
  link.click();
  URL.revokeObjectURL(url);
}

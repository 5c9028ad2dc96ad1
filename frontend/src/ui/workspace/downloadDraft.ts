/** Hands a kept draft to the user as a file. */
export function downloadDraft(
  task: number,
  draft: { baseRevision: number; edits: readonly unknown[] },
): void {
  const body = { task, base_revision: draft.baseRevision, edits: draft.edits };
  const url = URL.createObjectURL(new Blob([JSON.stringify(body, null, 1)], { type: "application/json" }));
  const link = document.createElement("a");
  link.href = url;
  link.download = `task-${task}-draft.json`;
  link.click();
  URL.revokeObjectURL(url);
}

/** What a token may be used for. */
export const SCOPES = [
  { value: "export:read", label: "read the export" },
  { value: "changes:read", label: "query changes" },
] as const;

export const scopeWords = (scopes: readonly string[]): string =>
  scopes.map((scope) => SCOPES.find(({ value }) => value === scope)?.label ?? scope).join(", ");

/** "replacement.unjustified" as a title: "Replacement unjustified". */
export function ruleTitle(code: string): string {
  const words = code.replaceAll(/[._]/g, " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** The pages of docs/rules, as the rules themselves wrote them; bundled when the frontend is built. */

const TEXTS = import.meta.glob<string>("../../../../docs/rules/*.md", {
  query: "?raw",
  import: "default",
  eager: true,
});
const PICTURES = import.meta.glob<string>("../../../../docs/rules/*.svg", {
  query: "?url",
  import: "default",
  eager: true,
});
const FOLDER = "../../../../docs/rules/";
const INDEX = "README";

/** The text below the page's title; `code` null: the index of all rules. Null: there is no such rule. */
export function ruleText(code: string | null): string | null {
  const text = TEXTS[`${FOLDER}${code ?? INDEX}.md`];
  if (text === undefined || code === INDEX) return null;
  return text.replace(/^# .*$/m, "").replaceAll(/<!--.*?-->/gs, "");
}

/** The address of a picture that a page names. */
export function pictureAddress(name: string): string | undefined {
  return PICTURES[FOLDER + name];
}

/** The rule that a page's link leads to: "link.gap.md" is `link.gap`; null: it leads elsewhere. */
export function linkedRule(address: string): string | null {
  const code = /^([\w.]+)\.md$/.exec(address)?.[1] ?? null;
  return code !== null && ruleText(code) !== null ? code : null;
}

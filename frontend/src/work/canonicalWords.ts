/** What bringing an update into its canonical form did, in words. */
import type { CanonicalForm, ElementKey, RenamedElement, SavedRevision } from "../api/types";
import { counted, KIND_WORDS } from "../ui/parts/words";

const MOST_NAMED = 3;

const firstNamed = (names: readonly string[]) => {
  const rest = names.length - MOST_NAMED;
  return `${names.slice(0, MOST_NAMED).join(", ")}${rest > 0 ? ` and ${rest} more` : ""}`;
};

const nameOf = (kind: RenamedElement["kind"], id: number) => `${KIND_WORDS[kind].toLowerCase()} ${id}`;

/** "lane 12, crossing 4, lane 7 and 2 more". */
export const elementsWords = (elements: readonly Pick<ElementKey, "kind" | "id">[]) =>
  firstNamed(elements.map(({ kind, id }) => nameOf(kind, id)));

/** "lane 12 is now lane 7, crossing 4 is now crossing 9 and 2 more": which elements have other ids. */
export const renamedWords = (renamed: readonly RenamedElement[]) =>
  firstNamed(renamed.map(({ kind, from, to }) => `${nameOf(kind, from)} is now ${nameOf(kind, to)}`));

/** After a save that told its updates otherwise than they were drawn; empty: it did not. */
export function retoldWords({
  canonical,
  joined,
  cut,
}: Pick<SavedRevision, "canonical" | "joined" | "cut">): string {
  const ids = canonical.length > 0 && renamedWords(canonical);
  const facts = [ids, ...seriesWords(joined, cut)].filter((fact) => fact !== false);
  return facts.length > 0 ? `Told as the simpler story: ${facts.join("; ")}.` : "";
}

const seriesWords = (joined: readonly number[], cut: readonly number[]) => [
  joined.length > 0 && `${counted(joined.length, "lane")} joined with another in series`,
  cut.length > 0 && `${counted(cut.length, "lane")} cut`,
];

/** After "Make canonical". Elements without an imported id get new ids of their own, which are not worth a word. */
export function canonicalWords(
  { renamed, joined, cut }: Pick<CanonicalForm, "renamed" | "joined" | "cut">,
  isImported: (element: { kind: RenamedElement["kind"]; id: number }) => boolean,
): string {
  const again = renamed.filter(({ kind, to }) => isImported({ kind, id: to }));
  const ids = again.length > 0 && `${counted(again.length, "id")} exchanged: ${renamedWords(again)}`;
  const facts = [ids, ...seriesWords(joined, cut)].filter((fact) => fact !== false);
  return `Made canonical${facts.length > 0 ? `. ${facts.join("; ")}` : ": the same map, told with fewer changes"}.`;
}

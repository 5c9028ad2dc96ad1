/** Declared macros: statements about structural updates, which the server checks against those that follow. */
import { type ElementKey, type KeyText, keyText } from "./elements";
import type { Declaration, Macros } from "./wire";

/** The declaration that names any of the elements. */
export function declarationOf(
  declarations: readonly Declaration[],
  elements: readonly ElementKey[],
): Declaration | null {
  return declarations.find((one) => touches(one, elements)) ?? null;
}

/** The list with one statement about these elements in place of all that touched them; `macros` null: with none. */
export function redeclared(
  declarations: readonly Declaration[],
  elements: readonly ElementKey[],
  macros: Macros | null,
): Declaration[] {
  const others = declarations.filter((one) => !touches(one, elements));
  return macros === null ? others : [...others, { elements: [...elements], macros }];
}

/** Whether two lists state the same, in whatever order. */
export function sameDeclarations(a: readonly Declaration[], b: readonly Declaration[]): boolean {
  const text = (list: readonly Declaration[]) => list.map(declarationText).sort().join("\n");
  return a.length === b.length && text(a) === text(b);
}

/**
 * The declarations of an editor who had `seen` before them, where others meanwhile made them `head`. What either added,
 * withdrew or changed counts; of two new statements on the same elements, the editor's. The server merges alike.
 */
export function merged(
  seen: readonly Declaration[],
  head: readonly Declaration[],
  mine: readonly Declaration[],
): Declaration[] {
  const texts = (list: readonly Declaration[]) => new Set(list.map(declarationText));
  const [before, now] = [texts(seen), texts(head)];
  const added = mine.filter((one) => !before.has(declarationText(one)));
  const told = new Set(added.map(elementsText));
  const theirs = head.filter((one) => !before.has(declarationText(one)) && !told.has(elementsText(one)));
  const standing = mine.filter((one) => before.has(declarationText(one)) && now.has(declarationText(one)));
  return [...added, ...theirs, ...standing];
}

/** The declarations about elements that have other ids now. */
export function renamed(
  declarations: readonly Declaration[],
  ids: ReadonlyMap<KeyText, number>,
): Declaration[] {
  return declarations.map((one) => ({
    ...one,
    elements: one.elements.map((key) => ({ ...key, id: ids.get(keyText(key)) ?? key.id })),
  }));
}

function touches({ elements }: Declaration, others: readonly ElementKey[]): boolean {
  const names = new Set(others.map(keyText));
  return elements.some((key) => names.has(keyText(key)));
}

function declarationText({ elements, macros }: Declaration): string {
  const { shape, appearance, lane_graph, lane_number } = macros;
  const facts = [shape, appearance, macros.function, lane_graph, lane_number];
  return [elementsText({ elements }), ...facts].join(" ");
}

function elementsText({ elements }: Pick<Declaration, "elements">): string {
  return elements.map(keyText).sort().join(" ");
}

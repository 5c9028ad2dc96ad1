/** Declared macros: statements about structural updates, which the server checks against those that follow. */
import { type ElementKey, keyText } from "./elements";
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

function touches({ elements }: Declaration, others: readonly ElementKey[]): boolean {
  const names = new Set(others.map(keyText));
  return elements.some((key) => names.has(keyText(key)));
}

function declarationText({ elements, macros }: Declaration): string {
  const { shape, appearance, lane_graph, lane_number } = macros;
  const facts = [shape, appearance, macros.function, lane_graph, lane_number];
  return [...elements.map(keyText).sort(), ...facts].join(" ");
}

/** What all actions stand on: the store, plans carried out as undo steps, refusals told, fresh ids. */
import type { StoreApi } from "zustand/vanilla";
import { changedElements } from "./classification";
import { sameDeclarations } from "./declarations";
import { applyChanges, elementOf, type MapDocument, reverseChanges } from "./document";
import type { IdSource } from "./ids";
import { lineOf } from "./lines";
import { baseCutAlike } from "./parts";
import { isRefusal, type Planned } from "./plan";
import type { EditorState, Outcome, Selection } from "./state";
import type { Declaration } from "./wire";

export const NO_IDS =
  "No new element can be made now: the server gave no ids. Try again when the connection is back.";
const READ_ONLY = "This task is open for reading only.";

export class Stage {
  readonly store: StoreApi<EditorState>;
  readonly #ids: IdSource;

  constructor(store: StoreApi<EditorState>, ids: IdSource) {
    this.store = store;
    this.#ids = ids;
  }

  get state(): EditorState {
    return this.store.getState();
  }

  say(text: string): void {
    this.store.setState({ notice: { text, serial: (this.state.notice?.serial ?? 0) + 1 } });
  }

  refuse(reason: string): { readonly ok: false; readonly reason: string } {
    this.store.setState({ staged: null });
    this.say(reason);
    return { ok: false, reason };
  }

  /** Carries out a plan as one undo step. */
  run(plan: (document: MapDocument) => Planned): Outcome {
    if (this.state.readOnly) return this.refuse(READ_ONLY);
    const planned = plan(this.state.current);
    if (isRefusal(planned)) return this.refuse(planned.refused);
    this.#ids.prepare();
    const { note, changes, select } = planned;
    const { history, current, declarations: before } = this.state;
    const after = planned.declarations ?? before;
    const selection = select === undefined ? this.state.selection : select;
    const declares = !sameDeclarations(before, after);
    if (changes.length === 0 && !declares) {
      this.store.setState({ staged: null, selection });
      return { ok: true };
    }
    const entry = { note, changes, ...(declares ? { declarations: { before, after } } : {}) };
    this.show(applyChanges(current, changes), selection, after);
    this.store.setState({ history: { done: [...history.done, entry], undone: [] } });
    return { ok: true };
  }

  /** Shows a plan without carrying it out; a refused one shows nothing new. */
  preview(plan: (document: MapDocument) => Planned): void {
    if (this.state.readOnly) return;
    const planned = plan(this.state.current);
    if (isRefusal(planned)) return;
    const { note, changes, select = this.state.selection } = planned;
    this.store.setState({ staged: { note, changes }, selection: select });
  }

  show(
    current: MapDocument,
    selection: Selection | null,
    declarations: readonly Declaration[] = this.state.declarations,
  ): void {
    this.store.setState({
      current,
      declarations,
      staged: null,
      selection: standing(current, selection),
      changedKeys: changedElements(baseCutAlike(this.state.base, current), current),
    });
  }

  undo(): void {
    const { history, current, selection } = this.state;
    const entry = history.done.at(-1);
    if (entry === undefined) return;
    const { changes, declarations } = entry;
    this.show(applyChanges(current, reverseChanges(changes)), selection, declarations?.before);
    this.store.setState({ history: { done: history.done.slice(0, -1), undone: [...history.undone, entry] } });
  }

  redo(): void {
    const { history, current, selection } = this.state;
    const entry = history.undone.at(-1);
    if (entry === undefined) return;
    this.show(applyChanges(current, entry.changes), selection, entry.declarations?.after);
    this.store.setState({ history: { done: [...history.done, entry], undone: history.undone.slice(0, -1) } });
  }

  async newId(kind: "lane_segment" | "pedestrian_crossing"): Promise<number> {
    const { base, saved, current } = this.state;
    return this.#ids.next((id) =>
      [base, saved, current].some((map) => elementOf(map, { kind, id }) !== null),
    );
  }

  prepareIds(): void {
    if (!this.state.readOnly) this.#ids.prepare();
  }
}

/** The selection as far as it still names something. */
function standing(document: MapDocument, selection: Selection | null): Selection | null {
  if (selection === null) return null;
  const element = elementOf(document, selection);
  if (element === null) return null;
  const { vertex } = selection;
  if (vertex === null || lineOf(element, vertex.side)?.[vertex.index] !== undefined) return selection;
  return { ...selection, vertex: null };
}

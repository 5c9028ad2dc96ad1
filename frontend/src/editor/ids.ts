/** New element ids out of blocks that the server hands out; none is used twice. */
import type { IdBlock } from "./wire";

export class IdSource {
  readonly #take: () => Promise<IdBlock>;
  readonly #ready: number[] = [];
  #asking: Promise<void> | null = null;

  constructor(take: () => Promise<IdBlock>) {
    this.#take = take;
  }

  /** Asks ahead, so that inserting works when the line drops; a failure shows when an id is needed. */
  prepare(): void {
    if (this.#ready.length === 0) this.#refill().catch(() => undefined);
  }

  async next(taken: (id: number) => boolean): Promise<number> {
    for (;;) {
      const id = this.#ready.shift();
      if (id === undefined) await this.#refill();
      else if (!taken(id)) return id;
    }
  }

  #refill(): Promise<void> {
    this.#asking ??= this.#take()
      .then(({ first_id, last_id }) => {
        for (let id = first_id; id <= last_id; id++) this.#ready.push(id);
      })
      .finally(() => {
        this.#asking = null;
      });
    return this.#asking;
  }
}

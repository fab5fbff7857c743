// States of the page for undo and redo.

export class History<T> {
  #past: T[] = [];
  #future: T[] = [];
  #now: T;

  constructor(now: T) {
    this.#now = now;
  }

  get canUndo() {
    return this.#past.length > 0;
  }

  get canRedo() {
    return this.#future.length > 0;
  }

  /** Adds a new state and deletes the undone states. False if the state did not change. */
  push(state: T): boolean {
    if (state === this.#now) return false;
    this.#past.push(this.#now);
    this.#now = state;
    this.#future = [];
    return true;
  }

  undo(): T | undefined {
    return this.#move(this.#past, this.#future);
  }

  redo(): T | undefined {
    return this.#move(this.#future, this.#past);
  }

  #move(from: T[], to: T[]): T | undefined {
    const state = from.pop();
    if (state === undefined) return undefined;
    to.push(this.#now);
    this.#now = state;
    return state;
  }
}

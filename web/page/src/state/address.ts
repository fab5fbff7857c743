// The address of the page and undo: both keep states as fragments.
import { signal } from '@preact/signals';
import type { Explorer } from './explorer';
import { read, write } from './fragment';
import { History } from './history';
import type { State } from './state';

/** Milliseconds between changes of the address: browsers refuse more than about six in a second. */
const PAUSE = 250;

export class Address {
  readonly #explorer: Explorer;
  readonly #history: History<string>;
  #timer = 0;
  /** True during a drag, whose state is not in the history yet. */
  #isDrag = false;
  readonly canUndo = signal(false);
  readonly canRedo = signal(false);
  /** Parts of the link that this page does not know. */
  readonly unknown = signal<readonly string[]>([]);

  constructor(explorer: Explorer, unknown: readonly string[]) {
    this.#explorer = explorer;
    this.unknown.value = unknown;
    this.#history = new History(write(explorer.state.value));
    explorer.onChange = (state, isFinal) => this.#changed(state, isFinal);
    addEventListener('popstate', () => this.#visit());
    addEventListener('hashchange', () => this.#visit());
  }

  undo() {
    this.#go(() => this.#history.undo());
  }

  redo() {
    this.#go(() => this.#history.redo());
  }

  #changed(state: State, isFinal: boolean) {
    const fragment = write(state);
    this.#isDrag = !isFinal;
    if (!isFinal) {
      // during a drag, replace the address instead of adding one to the browser's history
      clearTimeout(this.#timer);
      this.#timer = window.setTimeout(() => history.replaceState(null, '', `#${fragment}`), PAUSE);
      return;
    }
    clearTimeout(this.#timer);
    if (this.#history.push(fragment)) history.pushState(null, '', `#${fragment}`);
    this.#tell();
  }

  #go(move: () => string | undefined) {
    // a drag that goes on is a change of its own
    if (this.#isDrag) this.#changed(this.#explorer.state.value, true);
    const fragment = move();
    if (fragment === undefined) return;
    history.replaceState(null, '', `#${fragment}`);
    this.#apply(fragment);
    this.#tell();
  }

  /** Shows the state of an address that was typed, or reached by the buttons of the browser. */
  #visit() {
    const fragment = location.hash.slice(1);
    if (fragment === write(this.#explorer.state.value)) return;
    this.#history.push(fragment);
    this.#apply(fragment);
    this.#tell();
  }

  #apply(fragment: string) {
    // the address of a drag must not replace this one
    clearTimeout(this.#timer);
    this.#isDrag = false;
    const { state, unknown } = read(fragment, this.#explorer.catalog);
    this.unknown.value = unknown;
    this.#explorer.state.value = state;
    this.#explorer.refresh();
  }

  #tell() {
    this.canUndo.value = this.#history.canUndo;
    this.canRedo.value = this.#history.canRedo;
  }
}

// Debouncing: work that starts when no further request for it has come for a while.

export class Debounce {
  readonly #milliseconds: number;
  #timer = 0;

  constructor(milliseconds: number) {
    this.#milliseconds = milliseconds;
  }

  get isWaiting() {
    return this.#timer !== 0;
  }

  call(work: () => void) {
    clearTimeout(this.#timer);
    this.#timer = window.setTimeout(() => {
      this.#timer = 0;
      work();
    }, this.#milliseconds);
  }
}

// Answers kept with their questions, so that a late answer is not taken for one about the present
// state.
import { computed, effect, signal } from '@preact/signals';

/** Milliseconds until an answer out of date is marked. Answers that come sooner do not flicker. */
const DELAY = 150;

/** The latest answer to a question that changes with the state. */
export class Latest<T> {
  /** The question about the present state, as a text. It reads signals. */
  readonly question: () => string;
  readonly #given = signal<{ question: string; answer: T } | null>(null);
  readonly #isCurrent = computed(() => {
    const given = this.#given.value;
    return given !== null && given.question === this.question();
  });
  /**
   * The CSS class of an element that shows `last`. As an attribute it follows the state without a
   * new rendering of its component.
   */
  readonly mark = signal<'' | 'stale'>('');

  constructor(question: () => string) {
    this.question = question;
    let timer = 0;
    effect(() => {
      clearTimeout(timer);
      if (this.isCurrent || this.#given.value === null) this.mark.value = '';
      else timer = window.setTimeout(() => { this.mark.value = 'stale'; }, DELAY);
    });
  }

  give(question: string, answer: T) {
    this.#given.value = { question, answer };
  }

  /** The latest answer, of the present state or of an earlier one; null before the first answer. */
  get last(): T | null {
    return this.#given.value?.answer ?? null;
  }

  /** True if the latest answer is about the present state. */
  get isCurrent(): boolean {
    return this.#isCurrent.value;
  }

  /** The answer about the present state; null if there is none yet. */
  get current(): T | null {
    return this.isCurrent ? this.last : null;
  }
}

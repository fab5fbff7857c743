// Answers that are requested again when the content of the page changes.
import { useSignal } from '@preact/signals';
import { useEffect, useMemo } from 'preact/hooks';
import { Latest } from '../state/latest';

/** The result of a request: null if it has no answer, undefined if a newer request replaced it. */
type Result<T> = Promise<T | null | undefined>;

export interface Answered<T> {
  /** The last answer; null if there is none. */
  answer: T | null;
  /** True if the answer belongs to the present key, false if it belongs to an earlier one. */
  isCurrent: boolean;
  /** The CSS class of an element that shows the answer. */
  mark: '' | 'stale';
}

/** The last answer of `ask`, which is called `milliseconds` after the last change of `key`. */
export function useAnswer<T>(key: string, milliseconds: number, ask: () => Result<T>): Answered<T> {
  const present = useSignal(key);
  present.value = key;
  const latest = useMemo(() => new Latest<T | null>(() => present.value), []);
  useEffect(() => {
    let isCurrent = true;
    const timer = setTimeout(() => {
      void ask().then((answer) => {
        if (isCurrent && answer !== undefined) latest.give(key, answer);
      });
    }, milliseconds);
    return () => {
      isCurrent = false;
      clearTimeout(timer);
    };
  }, [key]);
  return { answer: latest.last, isCurrent: latest.isCurrent, mark: latest.mark.value };
}

// Answers that are requested again when the content of the page changes.
import { useEffect, useState } from 'preact/hooks';

/** The result of a request: null if it has no answer, undefined if a newer request replaced it. */
type Answered<T> = Promise<T | null | undefined>;

/**
 * The last answer of `ask`; null before the first answer. `milliseconds` after the last change of
 * `key`, `ask` is called again.
 */
export function useAnswer<T>(key: string, milliseconds: number, ask: () => Answered<T>): T | null {
  const [found, setFound] = useState<T | null>(null);
  useEffect(() => {
    let isCurrent = true;
    const timer = setTimeout(() => {
      void ask().then((answer) => {
        if (isCurrent && answer !== undefined) setFound(answer);
      });
    }, milliseconds);
    return () => {
      isCurrent = false;
      clearTimeout(timer);
    };
  }, [key]);
  return found;
}

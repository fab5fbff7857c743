// The answer to a question that follows what the page shows.
import { useEffect, useState } from 'preact/hooks';

/** An answer, null where there is none, or undefined where a newer question came first. */
type Answered<T> = Promise<T | null | undefined>;

/** The last answer; asked anew a moment after the text of `key` is another one. */
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

// Components that render again only when what they show changes, not at each move of the hand.
import { untracked, useComputed } from '@preact/signals';
import { useMemo } from 'preact/hooks';

/** The value of `read`, read again when the text of `key` is another one. */
export function useSteady<T>(key: () => string, read: () => T): T {
  const text = useComputed(key).value;
  return useMemo(() => untracked(read), [text]);
}

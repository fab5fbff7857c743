// Components that render again only when their content changes, not at each move of a slider.
import { untracked, useComputed } from '@preact/signals';
import { useMemo } from 'preact/hooks';

/** The value of `read`. It is read again only if `key` changes. */
export function useSteady<T>(key: () => string, read: () => T): T {
  const text = useComputed(key).value;
  return useMemo(() => untracked(read), [text]);
}

// Components that render again only when their content changes, not at each move of a slider.
import { useComputed } from '@preact/signals';
import { useRef } from 'preact/hooks';

/**
 * The result of `read`, a function of signals. Returns the earlier object if the new one has the
 * same JSON.
 */
export function useSteady<T>(read: () => T): T {
  const last = useRef<{ json: string; content: T } | null>(null);
  return useComputed(() => {
    const content = read();
    const json = JSON.stringify(content);
    if (last.current?.json !== json) last.current = { json, content };
    return last.current.content;
  }).value;
}

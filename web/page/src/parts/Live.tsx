// The answer as a sentence for screen readers, at most twice a second.
import { effect } from '@preact/signals';
import { useEffect, useState } from 'preact/hooks';
import { usePage } from './context';
import { length, sideways } from './lengths';

const PAUSE = 500;

export function Live() {
  const { explorer } = usePage();
  const [text, setText] = useState('');
  useEffect(() => {
    let timer = 0;
    let next = '';
    const stop = effect(() => {
      const { units, goal } = explorer.state.value;
      const outcomes = explorer.drive.last?.outcomes;
      const best = explorer.best.current?.flight[goal];
      next = explorer.refusal.value?.message ?? (outcomes
        ? `carry ${length(outcomes.carry, units)}, total ${length(outcomes.total, units)}, `
          + `${sideways(outcomes.lateral ?? 0, units)}`
          + `${typeof best === 'number' ? `; best ${goal} ${length(best, units)}` : ''}`
        : '');
      if (timer) return;
      timer = window.setTimeout(() => {
        timer = 0;
        setText(next);
      }, PAUSE);
    });
    return () => {
      clearTimeout(timer);
      stop();
    };
  }, [explorer]);
  return <p class="for-readers" aria-live="polite">{text}</p>;
}

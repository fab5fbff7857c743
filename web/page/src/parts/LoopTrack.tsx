// Draws the loop over the slider of the chosen parameter: the loop's carry minus the exact carry.
import { isRefused } from '../drive/drive';
import { labelOf } from '../setup/parameters';
import { digits } from '../setup/units';
import { loopCall, readLoop, worstOf } from '../state/loop';
import type { Loop } from '../state/loop';
import { useAnswer } from './answered';
import { usePage } from './context';
import { inLength, lengthUnit } from './lengths';
import { line } from './scale';
import { useWidth } from './size';
import { KNOB } from './Track';

const NODES = 400;
const HEIGHT = 40;
/** Space above and below the curve, so that a line at its edge stays visible, pixels. */
const ROOM = 4;

export function LoopTrack({ name }: { name: string }) {
  const { explorer } = usePage();
  const step = explorer.loopStep.value;
  return step !== null && explorer.mapNames.value[0] === name ? <ErrorCurve name={name} step={step} /> : null;
}

function ErrorCurve({ name, step }: { name: string; step: number }) {
  const { explorer } = usePage();
  const { low, high, step: difference } = explorer.sliderRange(name);
  const { preset, set } = explorer.design.value;
  // leave out the parameter's own value: the loop along the parameter does not depend on it
  const others = Object.entries(set).filter(([each]) => each !== name);
  const key = JSON.stringify([name, low, high, step, preset, others]);
  const { answer: loop, mark } = useAnswer(key, 150, async () => {
    const call = loopCall(explorer.requestBase(), { name, low, high }, NODES, step, difference);
    const numbers = await explorer.background.call('loop slider', call);
    if (!numbers) return undefined;
    return isRefused(numbers) ? null : readLoop(numbers);
  });
  if (!loop || loop.name !== name) return null;
  return <div class={mark}><Picture loop={loop} step={step} /></div>;
}

function Picture({ loop, step }: { loop: Loop; step: number }) {
  const { explorer } = usePage();
  const units = explorer.units.value;
  const { ref, width } = useWidth();
  const errors = Array.from(loop.loop, (value, k) => value - loop.carry[k]!);
  const known = errors.filter(Number.isFinite);
  const [least, most] = [Math.min(0, ...known), Math.max(0, ...known)];
  const x = (k: number) => KNOB + (k / (errors.length - 1)) * (width - 2 * KNOB);
  const y = (error: number) => ROOM + ((most - error) / (most - least || 1)) * (HEIGHT - 2 * ROOM);
  const points = errors.flatMap((error, k) => (Number.isFinite(error) ? [[x(k), y(error)] as const] : []));
  const text = `carry of the loop of ${digits(step * 1000, 0)} ms minus the exact carry: up to `
    + `${digits(inLength(worstOf(loop), units), 2)} ${lengthUnit(units)}`;
  return (
    <div class="loop-track" ref={ref}>
      <svg width={width} height={HEIGHT} role="img" aria-label={`Over the ${labelOf(loop.name)}: ${text}`}>
        <polyline class="ghost teeth-line" points={line(points)} />
        <line class="exact" x1={KNOB} x2={width - KNOB} y1={y(0)} y2={y(0)} />
      </svg>
      <p class="price">{text}</p>
    </div>
  );
}

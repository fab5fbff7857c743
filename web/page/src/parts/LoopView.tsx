// For lectures: the while-loop of the MAE 494 report beside the exact drive. The loop ends at its
// first step below the ground, so its carry is a sawtooth ("teeth"), and difference quotients of
// this carry are no derivatives.
import { useComputed } from '@preact/signals';
import { useEffect, useState } from 'preact/hooks';
import { isRefused, refusalOf } from '../drive/drive';
import { labelOf } from '../setup/parameters';
import { digits, fromSI, sizeOf, symbolOf, withUnit } from '../setup/units';
import type { Explorer } from '../state/explorer';
import { loopCall, readLoop, worstOf } from '../state/loop';
import type { Loop } from '../state/loop';
import { useAnswer } from './answered';
import { ChartScales } from './ChartScales';
import { usePage } from './context';
import { Figure } from './Figure';
import { inLength, lengthUnit, ticks } from './lengths';
import { line, MARGIN } from './scale';
import { useWidth } from './size';

const NODES = 300;
const HEIGHT = 170;
/** The fraction of a slider's range that is shown. */
const PART = 0.06;

async function flyLoop(explorer: Explorer, name: string, step: number, difference: number): Promise<Loop | { refused: string } | undefined> {
  const { low, high } = explorer.sliderRange(name);
  const middle = explorer.value(name) ?? (low + high) / 2;
  const half = (PART * (high - low)) / 2;
  const along = { name, low: middle - half, high: middle + half };
  const call = loopCall(explorer.requestBase(), along, NODES, step, difference);
  const numbers = await explorer.interactive.call('loop', call);
  if (!numbers) return undefined;
  return isRefused(numbers) ? { refused: refusalOf(numbers).message } : readLoop(numbers);
}

export function LoopView() {
  const { explorer } = usePage();
  const [isOpen, setOpen] = useState(false);
  return (
    <details class="lecture loop" onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>for lectures: a loop of time steps beside the exact drive</summary>
      {isOpen && <Lecture explorer={explorer} />}
    </details>
  );
}

function Lecture({ explorer }: { explorer: Explorer }) {
  const name = useComputed(() => explorer.mapNames.value[0]).value;
  const { unit } = explorer.field(name);
  const [step, setStep] = useState(0.01);
  const [power, setPower] = useState(-2);
  const difference = 10 ** power * sizeOf(unit);
  const key = JSON.stringify([explorer.design.value, explorer.units.value, name, step, power]);
  const { answer, mark } = useAnswer(key, 100, () => flyLoop(explorer, name, step, difference));
  const slide = (label: string, value: number, low: number, high: number, by: number, text: string, set: (value: number) => void) => (
    <label class="lecture-slider">
      {label} {text}
      <input type="range" min={low} max={high} step={by} value={value} aria-valuetext={text}
        onInput={(event) => set(Number(event.currentTarget.value))} />
    </label>
  );
  return (
    <>
      {slide('time step', step * 1000, 1, 50, 1, `${digits(step * 1000, 0)} ms`, (value) => setStep(value / 1000))}
      <Overlay step={step} name={name} />
      {slide('difference over', power, -6, 0, 0.5, `${(10 ** power).toPrecision(2)} ${symbolOf(unit)}`, setPower)}
      {answer && ('refused' in answer ? <p class="message">{answer.refused}</p>
        : <div class={mark}><Pictures explorer={explorer} loop={answer} /></div>)}
    </>
  );
}

/** A switch that lays the loop over the map and the slider, while this view is open. */
function Overlay({ step, name }: { step: number; name: string }) {
  const { explorer } = usePage();
  const [isOver, setOver] = useState(false);
  useEffect(() => {
    explorer.loopStep.value = isOver ? step : null;
  }, [isOver, step]);
  useEffect(() => () => { explorer.loopStep.value = null; }, []);
  const isCarry = explorer.state.value.goal === 'carry';
  return (
    <p>
      <label>
        <input type="checkbox" checked={isOver} onChange={() => setOver(!isOver)} />
        {' '}lay the loop over the slider of the {labelOf(name)} and over the map
        {isCarry ? '' : ' (only a map of the carry shows it)'}
      </label>
    </p>
  );
}

function Pictures({ explorer, loop }: { explorer: Explorer; loop: Loop }) {
  const units = explorer.units.value;
  const { unit } = explorer.field(loop.name);
  const length = lengthUnit(units);
  const per = sizeOf(unit) / sizeOf(length);
  const carries = [loop.loop, loop.carry].map((values) => Array.from(values, (value) => inLength(value, units)));
  const slopes = [loop.difference, loop.slope].map((values) => Array.from(values, (value) => value * per));
  const at = Array.from(loop.at, (value) => fromSI(value, unit));
  const worst = inLength(worstOf(loop), units);
  const steepest = slopes[0]!.filter(Number.isFinite).reduce((most, slope) => (Math.abs(slope) > Math.abs(most) ? slope : most), 0);
  const middle = slopes[1]![Math.floor(NODES / 2)] ?? NaN;
  const symbol = symbolOf(unit);
  const perUnit = `${length} per ${symbol === '°' ? 'degree' : symbol || '1'}`;
  return (
    <>
      <Chart name="teeth" title={`Carry over ${labelOf(loop.name)}, ${length}`}
        legend={['loop of time steps', 'exact']} at={at} curves={carries} unit={length} across={unit}
        sentence={`The loop is up to ${digits(worst, 2)} ${length} from the exact carry, and jumps where its number of time steps changes.`} />
      <Chart name="slopes" title={`Slope of the carry over ${labelOf(loop.name)}, ${perUnit}`}
        legend={['differences of the loop', 'exact']} at={at} curves={slopes} unit={perUnit} across={unit}
        sentence={`Differences of the loop reach ${digits(steepest, 1)} ${perUnit}; the exact slope is ${digits(middle, 2)} ${perUnit}.`} />
    </>
  );
}

interface ChartProps {
  name: string;
  title: string;
  /** The names of the two curves. */
  legend: [loop: string, exact: string];
  at: number[];
  /** The values of the loop, then those of the exact drive. */
  curves: number[][];
  unit: string;
  /** The unit of `at`. */
  across: string;
  sentence: string;
}

function Chart({ name, title, legend, at, curves, unit, across, sentence }: ChartProps) {
  const { ref, width } = useWidth();
  const known = curves.flat().filter(Number.isFinite);
  const [low, high] = [Math.min(...known), Math.max(...known)];
  const [first, last] = [at[0] ?? 0, at.at(-1) ?? 1];
  const x = (value: number) => MARGIN.left + ((value - first) / (last - first)) * (width - MARGIN.left - MARGIN.right);
  const y = (value: number) => MARGIN.top + ((high - value) / (high - low || 1)) * (HEIGHT - MARGIN.top - MARGIN.bottom);
  const points = (curve: number[]) => line(curve.map((value, k) => [x(at[k]!), y(value)] as const)
    .filter(([, height]) => Number.isFinite(height)));
  const legendAt = (k: number) => width - 250 + 170 * k;
  const table = () => ({
    head: [`[${symbolOf(across)}]`, `loop [${unit}]`, `exact [${unit}]`],
    rows: at.filter((_, k) => k % 15 === 0).map((value, k) =>
      [digits(value, 3), ...curves.map((curve) => digits(curve[k * 15] ?? NaN, 3))]),
  });
  return (
    <Figure name={name} title={title} sentence={sentence} table={table} place={ref}>
      <svg width={width} height={HEIGHT} role="img" aria-label={`${title}. ${sentence}`}>
        <ChartScales width={width} bottom={HEIGHT - 14}
          across={{ ticks: ticks(first, last, width / 110), place: x, text: (tick) => withUnit(String(Number(tick.toFixed(3))), across) }}
          up={{ ticks: ticks(low, high, 3), place: y, text: (tick) => String(Number(tick.toPrecision(4))) }} />
        <polyline class="ghost teeth-line" points={points(curves[0]!)} />
        <polyline class="yours" points={points(curves[1]!)} />
        {legend.map((text, k) => (
          <g key={text}>
            <polyline class={k === 0 ? 'ghost teeth-line' : 'yours'} points={`${legendAt(k)},6 ${legendAt(k) + 24},6`} />
            <text class="tick" x={legendAt(k) + 28} y={10}>{text}</text>
          </g>
        ))}
      </svg>
    </Figure>
  );
}

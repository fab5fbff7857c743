// For lectures: the optimizer, one iteration at a time.
import { useState } from 'preact/hooks';
import { labelOf } from '../setup/parameters';
import { signed, withUnit } from '../setup/units';
import type { Explorer } from '../state/explorer';
import type { Iteration, Iterations } from '../state/iterations';
import { readIterations, iterationsCall } from '../state/iterations';
import { isRefused, refusalOf } from '../drive/drive';
import { useAnswer } from './answered';
import { usePage } from './context';
import { Figure } from './Figure';
import { inLength, length, lengthUnit } from './lengths';
import { useWidth } from './size';
import { IterationsPicture } from './IterationsPicture';

const BOUND: Readonly<Record<number, string>> = { [-1]: 'lower bound', 1: 'upper bound' };

export function IterationsView() {
  const [isOpen, setOpen] = useState(false);
  return (
    <details class="lecture optimizer" onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>for lectures: the optimizer, step by step</summary>
      {isOpen && <Lecture />}
    </details>
  );
}

async function search(explorer: Explorer): Promise<Iterations | { refused: string } | undefined> {
  const goal = explorer.goal.value;
  const names = explorer.varied.value;
  const ranges = names.map((name) => explorer.sliderRange(name));
  const call = iterationsCall(explorer.requestBase(), goal, names, ranges);
  const numbers = await explorer.background.call('iterations', call);
  if (!numbers) return undefined;
  return isRefused(numbers)
    ? { refused: refusalOf(numbers).message } : readIterations(numbers, goal, ranges);
}

function Lecture() {
  const { explorer } = usePage();
  const { goal, units } = explorer.state.value;
  const key = JSON.stringify([explorer.design.value, goal, units, explorer.varied.value]);
  const { answer, mark } = useAnswer(key, 150, () => search(explorer));
  if (!answer) return <p>The optimizer has no steps yet.</p>;
  return 'refused' in answer ? <p class="message">{answer.refused}</p>
    : <Stepper iterations={answer} mark={mark} />;
}

function Stepper({ iterations, mark }: { iterations: Iterations; mark: string }) {
  const { explorer } = usePage();
  const { ref, width } = useWidth();
  const [wanted, setWanted] = useState(0);
  const last = iterations.list.length - 1;
  const at = Math.min(wanted, last);
  const iteration = iterations.list[at];
  if (!iteration) return <p>{iterations.message}</p>;
  const go = (to: number) => setWanted(Math.min(last, Math.max(0, to)));
  const press = (event: KeyboardEvent) => {
    // leave the arrow keys to a slider that has the focus
    if (event.target instanceof HTMLInputElement) return;
    if (event.key === 'ArrowLeft') go(at - 1);
    else if (event.key === 'ArrowRight') go(at + 1);
    else return;
    event.preventDefault();
  };
  const sentence = sentenceOf(iteration, iterations, explorer, at === last);
  const place = `step ${at + 1} of ${last + 1}`;
  return (
    <Figure name="iterations" title="Optimizer" sentence={sentence} mark={mark} isLive isOpen place={ref}
      table={() => tableOf(iterations, explorer)} at={at}
      below={(
        <div class="stepper" role="group" aria-label="steps of the optimizer" onKeyDown={press}>
          <button type="button" aria-disabled={at === 0} onClick={() => go(at - 1)}>◂ previous</button>
          <input type="range" min={0} max={last} step={1} value={at} aria-label="step" aria-valuetext={place}
            onInput={(event) => go(Number(event.currentTarget.value))} />
          <button type="button" aria-disabled={at === last} onClick={() => go(at + 1)}>next ▸</button>
          <span>{place}</span>
        </div>
      )}>
      <IterationsPicture iterations={iterations} at={at} width={width} sentence={sentence} mark={mark} />
    </Figure>
  );
}

/** Values of the varied parameters: "loft 9.20°, attack angle 10.00° (at its upper bound)". */
function placeOf(x: ArrayLike<number>, { names }: Iterations, explorer: Explorer, bounds?: ArrayLike<number>): string {
  return names.map((name, k) => {
    const value = withUnit(explorer.shown(name, x[k] ?? NaN), explorer.field(name).unit);
    const bound = BOUND[bounds?.[k] ?? 0];
    return `${labelOf(name)} ${value}${bound ? ` (at its ${bound})` : ''}`;
  }).join(', ');
}

const gainOf = (metres: number, explorer: Explorer) => {
  const units = explorer.units.value;
  return `${signed(inLength(metres, units), 3)} ${lengthUnit(units)}`;
};

function sentenceOf(iteration: Iteration, iterations: Iterations, explorer: Explorer, isLast: boolean): string {
  const units = explorer.units.value;
  const begins = iteration.number === 0
    ? (iteration.search === 0 ? 'The search begins at your drive. ' : 'A sample of the ranges has a better drive, from which another search begins. ')
    : '';
  const here = `${begins}Iteration ${iteration.number}: ${iterations.goal} ${length(iteration.value, units)} at ${placeOf(iteration.x, iterations, explorer, iteration.bounds)}, `
    + `KKT residual ${iteration.residual.toExponential(1)}.`;
  const { trial } = iteration;
  if (!trial) return `${here} ${isLast ? `The search ends: ${iterations.message}.` : 'This search ends here.'}`;
  const model = trial.isReflected ? 'The model has no maximum, so its curvature is reflected; it' : 'The quadratic model';
  const drive = Number.isFinite(trial.actual)
    ? `the drive there brings ${gainOf(trial.actual, explorer)}` : 'there is no drive';
  return `${here} ${model} predicts ${gainOf(trial.predicted, explorer)} for ${placeOf(trial.x, iterations, explorer)}; `
    + `${drive}: the step is ${trial.isAccepted ? 'accepted' : 'not accepted'}.`;
}

function tableOf(iterations: Iterations, explorer: Explorer) {
  const units = explorer.units.value;
  const unit = lengthUnit(units);
  const value = (name: string, x: number | undefined) => explorer.shown(name, x ?? NaN, 2);
  const parameters = iterations.names.map((name) => {
    const symbol = withUnit('', explorer.field(name).unit).trim();
    return `${labelOf(name)}${symbol ? ` [${symbol}]` : ''}`;
  });
  const gain = (metres = NaN) => (Number.isFinite(metres) ? inLength(metres, units).toExponential(3) : '–');
  const hasTwo = iterations.list.some(({ search: number }) => number > 0);
  return {
    head: ['iteration', ...parameters, `${iterations.goal} [${unit}]`, 'at bounds', 'KKT residual',
      `trust region of ${parameters[0]}`, `predicted [${unit}]`, `actual [${unit}]`, 'step'],
    rows: iterations.list.map((iteration) => {
      const { trial } = iteration;
      const bounds = iterations.names.filter((_, k) => iteration.bounds[k] !== 0).map(labelOf).join(', ');
      return [
        `${hasTwo ? `${iteration.search + 1}: ` : ''}${iteration.number}`,
        ...iterations.names.map((name, k) => value(name, iteration.x[k])),
        inLength(iteration.value, units).toFixed(4),
        bounds || 'none',
        iteration.residual.toExponential(1),
        `${value(iterations.names[0]!, iteration.low[0])} to ${value(iterations.names[0]!, iteration.high[0])}`,
        gain(trial?.predicted),
        gain(trial?.actual),
        trial ? (trial.isAccepted ? 'accepted' : 'not accepted') : 'end',
      ];
    }),
  };
}

// For lectures: the optimizer, one iteration at a time.
import { useState } from 'preact/hooks';
import { labelOf } from '../setup/parameters';
import { signed, withUnit } from '../setup/units';
import type { Explorer } from '../state/explorer';
import type { Step, Steps } from '../state/steps';
import { readSteps, stepsCall } from '../state/steps';
import { isRefused, refusalOf } from '../drive/drive';
import { varyOf } from '../state/state';
import { useAnswer } from './answered';
import { usePage } from './context';
import { Figure } from './Figure';
import { inLength, length, lengthUnit } from './lengths';
import { useWidth } from './size';
import { StepsPicture } from './StepsPicture';

const BOUND: Readonly<Record<number, string>> = { [-1]: 'lower bound', 1: 'upper bound' };

export function StepsView() {
  const [isOpen, setOpen] = useState(false);
  return (
    <details class="lecture optimizer" onToggle={(event) => setOpen(event.currentTarget.open)}>
      <summary>for lectures: the optimizer, step by step</summary>
      {isOpen && <Lecture />}
    </details>
  );
}

async function search(explorer: Explorer): Promise<Steps | { refused: string } | undefined> {
  const { goal, units } = explorer.state.value;
  const names = varyOf(explorer.state.value);
  const ranges = names.map((name) => explorer.travel(name));
  const call = stepsCall(explorer.setup(), goal, units, names, ranges);
  const first = (await explorer.desk.calls('steps', [call]))?.numbers[0];
  if (!first) return undefined;
  return isRefused(first) ? { refused: refusalOf(first).message } : readSteps(first, ranges);
}

function Lecture() {
  const { explorer } = usePage();
  const { goal, units } = explorer.state.value;
  const key = JSON.stringify([explorer.design.value, goal, units, varyOf(explorer.state.value)]);
  const found = useAnswer(key, 150, () => search(explorer));
  if (!found) return <p>The optimizer has no steps yet.</p>;
  return 'refused' in found ? <p class="message">{found.refused}</p> : <Stepper steps={found} />;
}

function Stepper({ steps }: { steps: Steps }) {
  const { explorer } = usePage();
  const { ref, width } = useWidth();
  const [wanted, setWanted] = useState(0);
  const last = steps.list.length - 1;
  const at = Math.min(wanted, last);
  const step = steps.list[at];
  if (!step) return <p>{steps.message}</p>;
  const go = (to: number) => setWanted(Math.min(last, Math.max(0, to)));
  const press = (event: KeyboardEvent) => {
    // the slider moves by its own arrow keys
    if (event.target instanceof HTMLInputElement) return;
    if (event.key === 'ArrowLeft') go(at - 1);
    else if (event.key === 'ArrowRight') go(at + 1);
    else return;
    event.preventDefault();
  };
  const sentence = sentenceOf(step, steps, explorer, at === last);
  const place = `step ${at + 1} of ${last + 1}`;
  return (
    <Figure name="steps" title="Optimizer" sentence={sentence} isLive isOpen place={ref}
      table={() => tableOf(steps, explorer)} at={at}
      below={(
        <div class="stepper" role="group" aria-label="steps of the optimizer" onKeyDown={press}>
          <button type="button" aria-disabled={at === 0} onClick={() => go(at - 1)}>◂ previous</button>
          <input type="range" min={0} max={last} step={1} value={at} aria-label="step" aria-valuetext={place}
            onInput={(event) => go(Number(event.currentTarget.value))} />
          <button type="button" aria-disabled={at === last} onClick={() => go(at + 1)}>next ▸</button>
          <span>{place}</span>
        </div>
      )}>
      <StepsPicture steps={steps} at={at} width={width} sentence={sentence} />
    </Figure>
  );
}

/** Values of the varied parameters: "loft 9.20°, attack angle 10.00° (at its upper bound)". */
function placeOf(x: ArrayLike<number>, { names }: Steps, explorer: Explorer, bounds?: ArrayLike<number>): string {
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

function sentenceOf(step: Step, steps: Steps, explorer: Explorer, isLast: boolean): string {
  const { goal, units } = explorer.state.value;
  const begins = step.iteration === 0
    ? (step.search === 0 ? 'The search begins at your drive. ' : 'A sample of the ranges has a better drive, from which another search begins. ')
    : '';
  const here = `${begins}Iteration ${step.iteration}: ${goal} ${length(step.value, units)} at ${placeOf(step.x, steps, explorer, step.bounds)}, `
    + `KKT residual ${step.residual.toExponential(1)}.`;
  const { trial } = step;
  if (!trial) return `${here} ${isLast ? `The search ends: ${steps.message}.` : 'This search ends here.'}`;
  const model = trial.isReflected ? 'The model has no maximum, so its curvature is reflected; it' : 'The quadratic model';
  const drive = Number.isFinite(trial.actual)
    ? `the drive there brings ${gainOf(trial.actual, explorer)}` : 'there is no drive';
  return `${here} ${model} predicts ${gainOf(trial.predicted, explorer)} for ${placeOf(trial.x, steps, explorer)}; `
    + `${drive}: the step is ${trial.isAccepted ? 'accepted' : 'not accepted'}.`;
}

function tableOf(steps: Steps, explorer: Explorer) {
  const { goal, units } = explorer.state.value;
  const unit = lengthUnit(units);
  const value = (name: string, x: number | undefined) => explorer.shown(name, x ?? NaN, 2);
  const parameters = steps.names.map((name) => {
    const symbol = withUnit('', explorer.field(name).unit).trim();
    return `${labelOf(name)}${symbol ? ` [${symbol}]` : ''}`;
  });
  const gain = (metres = NaN) => (Number.isFinite(metres) ? inLength(metres, units).toExponential(3) : '–');
  const hasTwo = steps.list.some(({ search: number }) => number > 0);
  return {
    head: ['iteration', ...parameters, `${goal} [${unit}]`, 'at bounds', 'KKT residual',
      `trust region of ${parameters[0]}`, `predicted [${unit}]`, `actual [${unit}]`, 'step'],
    rows: steps.list.map((step) => {
      const { trial } = step;
      const bounds = steps.names.filter((_, k) => step.bounds[k] !== 0).map(labelOf).join(', ');
      return [
        `${hasTwo ? `${step.search + 1}: ` : ''}${step.iteration}`,
        ...steps.names.map((name, k) => value(name, step.x[k])),
        inLength(step.value, units).toFixed(4),
        bounds || 'none',
        step.residual.toExponential(1),
        `${value(steps.names[0]!, step.low[0])} to ${value(steps.names[0]!, step.high[0])}`,
        gain(trial?.predicted),
        gain(trial?.actual),
        trial ? (trial.isAccepted ? 'accepted' : 'not accepted') : 'end',
      ];
    }),
  };
}

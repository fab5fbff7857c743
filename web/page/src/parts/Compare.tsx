// Up to four designs beside each other, and the causes of a difference.
import { useComputed } from '@preact/signals';
import { labelOf } from '../setup/parameters';
import type { Design } from '../setup/design';
import { lawOf, numberOf } from '../setup/design';
import { withUnit } from '../setup/units';
import type { Explorer } from '../state/explorer';
import { settingsOf } from '../setup/words';
import { DESIGN_NAMES, MOST_DESIGNS } from '../state/state';
import { useAnswer } from './answered';
import { usePage } from './context';
import { TableFiles, TableView } from './Figure';
import { lengthChange } from './lengths';
import { outcomesOf, ROWS, shown } from './outcomes';

export function Compare() {
  const { explorer } = usePage();
  const active = useComputed(() => explorer.state.value.active).value;
  const count = useComputed(() => explorer.state.value.designs.length).value;
  const names = DESIGN_NAMES.slice(0, count);
  const change = (designs: readonly Design[], next: number) =>
    explorer.change({ ...explorer.state.value, designs, active: next });
  const add = () => change([...explorer.state.value.designs, { ...explorer.design.value }], count);
  const remove = () => change(
    explorer.state.value.designs.filter((_, at) => at !== active), Math.max(0, active - 1));
  return (
    <section class="compare" aria-label="designs">
      <h2>Designs beside each other</h2>
      {count > 1 && (
        <fieldset class="switch">
          <legend>the sliders move</legend>
          {names.map((name, at) => (
            <label key={name}>
              <input type="radio" name="design" checked={at === active}
                onChange={() => change(explorer.state.value.designs, at)} /> {name}
            </label>
          ))}
        </fieldset>
      )}
      <p class="buttons">
        <button type="button" disabled={count >= MOST_DESIGNS} onClick={add}>
          keep this design as {DESIGN_NAMES[active]}, and change a copy
        </button>
        {count > 1
          && <button type="button" onClick={remove}>remove {DESIGN_NAMES[active]}</button>}
      </p>
      {count > 1 && <Beside />}
      {count > 1 && <Causes other={active === 0 ? 1 : active} />}
    </section>
  );
}

/** The printed values of a parameter in the designs. */
function valueTexts(explorer: Explorer, name: string, designs: readonly Design[]): string[] {
  const typed = (design: Design) => design.set[name] ?? '–';
  const units = designs.map((design) =>
    explorer.catalog.parameter(name, lawOf(design, explorer.catalog))?.shown_in);
  // a coefficient has other units in other laws
  if (units.some((unit) => unit === undefined || unit !== units[0])) return designs.map(typed);
  const values = designs.map((design) => numberOf(name, design, explorer.catalog));
  const numbers = explorer.distinct(name, values.map((value) => value ?? NaN));
  const { unit } = explorer.field(name);
  return designs.map((design, at) => {
    const value = values[at];
    if (value === null) return 'not stated';
    return Number.isFinite(value) ? withUnit(numbers[at]!, unit) : typed(design);
  });
}

function Beside() {
  const { explorer } = usePage();
  const { units } = explorer;
  const flown = explorer.flownDesigns.last;
  if (!flown) return null;
  const designs = flown.map(({ design }) => design);
  const changed = [...new Set(designs.flatMap(({ set }) => Object.keys(set)))].filter((name) =>
    designs.some(({ set }) => set[name] !== designs[0]?.set[name]));
  const presets = designs.map(({ preset }) => preset);
  const rows = [
    ...(new Set(presets).size > 1 ? [['preset', ...presets]] : []),
    ...changed.map((name) => [
      explorer.catalog.parameter(name) ? labelOf(name) : name,
      ...valueTexts(explorer, name, designs),
    ]),
    ...ROWS.map((row) => [
      row.label,
      ...flown.map(({ drive }) => (drive ? shown(row, drive, units.value) : '–')),
    ]),
  ];
  const table = { head: ['', ...designs.map((_, at) => DESIGN_NAMES[at]!)], rows };
  const numbers = () => Object.fromEntries(flown.map(({ design, drive }, at) =>
    [DESIGN_NAMES[at]!, { ...design, outcomes: drive && outcomesOf(drive) }]));
  return (
    <div class={explorer.flownDesigns.mark}>
      <TableView {...table} />
      <TableFiles name="designs" table={() => table} numbers={numbers} />
    </div>
  );
}

interface Share {
  cause: string;
  share: number;
}

interface Difference {
  /** Index of the design that is beside the first one. */
  other: number;
  of: string;
  difference: number;
  by_parameter: { shares: Share[] } | null;
  by_launch: { shares: Share[] } | null;
}

/** The causes of the difference between the first design and another one, from `compare`. */
function Causes({ other }: { other: number }) {
  const { explorer } = usePage();
  const { designs, goal, units } = explorer.state.value;
  const [first, second] = [designs[0]!, designs[other]!];
  const key = JSON.stringify([first, second, goal]);
  const words = ['compare', first.preset, second.preset, ...settingsOf(first, '--set-a'),
    ...settingsOf(second, '--set-b'), '--of', goal, '--json'];
  const { answer, mark } = useAnswer(key, 300, async () => {
    const reply = await explorer.background.command('compare', words);
    if (!reply) return undefined;
    const found = reply.exit === 0 ? (JSON.parse(reply.answer) as { outcomes: Difference[] }).outcomes[0] : null;
    return found ? { ...found, other } : null;
  });
  if (!answer) return null;
  const list = (shares: Share[] | undefined) => (shares ?? [])
    .map(({ cause, share }) => `${labelOf(cause)} ${lengthChange(share, units)}`).join(', ') || 'none';
  return (
    <p role="status" class={mark}>
      {DESIGN_NAMES[answer.other]} beside A: {answer.of} {lengthChange(answer.difference, units)}. By parameter:{' '}
      {list(answer.by_parameter?.shares)}. By launch: {list(answer.by_launch?.shares)}.
    </p>
  );
}

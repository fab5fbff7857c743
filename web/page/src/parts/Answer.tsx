// Your drive, the best drive, their difference, and the gain for one more unit of each parameter.
import { useComputed } from '@preact/signals';
import { ownWarnings } from '../drive/drive';
import { priceOf } from '../drive/price';
import { labelOf } from '../setup/parameters';
import { digits, fromSI, toSI, withUnit } from '../setup/units';
import type { Best } from '../state/best';
import { usePage } from './context';
import { length, lengthChange } from './lengths';
import { useSteady } from './steady';

export function Answer() {
  const { explorer } = usePage();
  const { drive, best, refusal, driveMark } = explorer;
  const units = explorer.units.value;
  const goal = explorer.goal.value;
  const yours = drive.last?.outcomes;
  const theirs = best.last?.flight;
  const names = useComputed(() => (best.last?.names ?? explorer.varied.value).map(labelOf).join(' and ')).value;
  const rows = (['carry', 'total'] as const).map((name) => {
    const [mine, most] = [yours?.[name], theirs?.[name]];
    return (
      <tr key={name} class={name === goal ? 'goal' : ''}>
        <th scope="row">{name}</th>
        <td>{length(mine, units)}</td>
        <td class={best.mark}>{length(most, units)}</td>
        <td>
          {best.isCurrent && mine !== undefined && typeof most === 'number' ? lengthChange(most - mine, units) : '–'}
        </td>
      </tr>
    );
  });
  return (
    <section class={`answer ${driveMark.value}`} aria-label="answer">
      {refusal.value && <p class="message" role="alert">{refusal.value.message}</p>}
      <table>
        <thead>
          <tr><td /><th scope="col">yours</th><th scope="col">best {names}</th><th scope="col">difference</th></tr>
        </thead>
        <tbody>{rows}{best.last && <Values best={best.last} />}</tbody>
      </table>
      <Worth />
      {explorer.bestMessage.current && !refusal.value
        && <p class="message">No best drive: {explorer.bestMessage.current}</p>}
      <p class="buttons">
        <button type="button" disabled={!best.current} onClick={() => explorer.goToBest()}>
          go to the best drive
        </button>
      </p>
      <Warnings />
    </section>
  );
}

/** The warnings about your drive, and those that only the best drive has. */
function Warnings() {
  const { drive, ghost } = usePage().explorer;
  const mine = drive.last?.warnings ?? [];
  const theirs = ownWarnings(ghost.current, drive.last);
  return (
    <>
      {mine.map((warning) => <p class="warning" key={warning}>{warning}</p>)}
      {theirs.map((warning) => <p class="warning" key={`best ${warning}`}>The best drive: {warning}</p>)}
    </>
  );
}

/**
 * A row for each parameter that the best drive may change: your value, the best value, and the
 * difference.
 */
const Values = ({ best }: { best: Best }) => (
  <>
    {best.names.map((name) => <ValueRow name={name} theirs={best.values[name] ?? NaN} key={name} />)}
  </>
);

function ValueRow({ name, theirs }: { name: string; theirs: number }) {
  const { explorer } = usePage();
  const { mine, typed, unit, decimals } = useSteady(() => ({
    mine: explorer.value(name), typed: explorer.design.value.set[name], ...explorer.field(name),
  }));
  const isKnown = mine !== null && Number.isFinite(mine);
  const shown = (value: number) => withUnit(digits(fromSI(value, unit), decimals + 1), unit);
  // the conversion of 0 cancels the offset of a temperature unit
  const difference = isKnown && explorer.best.isCurrent ? shown(theirs - mine + toSI(0, unit)) : '–';
  return (
    <tr>
      <th scope="row">{labelOf(name)}</th>
      <td>{isKnown ? shown(mine) : mine === null ? 'not stated' : typed ?? 'inf'}</td>
      <td class={explorer.best.mark}>{shown(theirs)}</td>
      <td>{/^[\u2212\u2013]/.test(difference) ? difference : `+${difference}`}</td>
    </tr>
  );
}

/**
 * What one more unit of a parameter gains: at your drive, and beyond the bound for the parameters
 * that the best drive has at a bound.
 */
function Worth() {
  const { explorer } = usePage();
  const { slopes, best } = explorer;
  const units = explorer.units.value;
  const goal = explorer.goal.value;
  const price = (name: string) => {
    const slope = slopes.value.get(name);
    return slope ? `${labelOf(name)} ${priceOf(name, slope, explorer.unit(name), units).text}` : null;
  };
  const names = explorer.isLaunch.value ? ['launch.launch_angle', 'launch.ball_speed'] : ['club.loft', 'swing.attack_angle', 'swing.speed'];
  const prices = names.map(price).filter((text) => text !== null);
  const { names: varied = [], beyond = {} } = best.last ?? {};
  const bounds = varied.filter((name) => Math.abs(beyond[name] ?? 0) > 1e-6);
  return (
    <p class="worth">
      {prices.length > 0 && <>{goal} here: {prices.join('; ')}.</>}
      {bounds.map((name) => {
        const first = beyond[name] ?? 0;
        const { text } = priceOf(name, { first, second: 0 }, explorer.unit(name), units);
        return <span class={best.mark} key={name}> The best {labelOf(name)} is at the end of its slider: {text} beyond.</span>;
      })}
    </p>
  );
}

// One parameter: slider, number field, price, band, meaning.
import { useState } from 'preact/hooks';
import { bandOf, LOSS, priceOf } from '../drive/price';
import { firstOf, isIdle, NONE, defaultOf, WHEN_UNSET } from '../setup/design';
import { labelInGroup, labelOf } from '../setup/parameters';
import { decimalsOf } from '../setup/slider';
import { digits, fromSI, parts, symbolOf, toSI, withUnit } from '../setup/units';
import { withVaried } from '../state/state';
import type { Explorer } from '../state/explorer';
import { usePage } from './context';
import { useSteady } from './steady';
import { LoopTrack } from './LoopTrack';
import { Track } from './Track';

interface Props {
  name: string;
  isInGroup?: boolean;
}

export function SliderRow({ name, isInGroup = false }: Props) {
  const { explorer } = usePage();
  const [isAsked, setAsked] = useState(false);
  const id = name.replace(/\./g, '-');
  const label = isInGroup ? labelInGroup(name) : labelOf(name);
  const row = useSteady(() => rowOf(explorer, name));
  const { sliderRange, unit, value, at, decimals, isSet, units, message } = row;
  const slide = (event: Event, isFinal: boolean) =>
    explorer.slide(name, toSI(Number((event.target as HTMLInputElement).value), unit), isFinal);
  const spoken = value === null ? 'not stated'
    : Number.isFinite(value) ? withUnit(digits(fromSI(at, unit), decimals), unit) : row.shown;
  return (
    <div class={`slider${isSet ? ' changed' : ''}`}>
      <div class="row">
        <label for={`slide-${id}`}>{label}</label>
        <Field name={name} id={id} label={label} unit={unit} shown={row.shown} hasMessage={message !== null} />
        <span class="unit">{symbolOf(unit)}</span>
        <button type="button" class="reset" disabled={!row.hasReset} onClick={() => explorer.reset(name)}
          aria-label={`reset ${label}`} title="back to the preset">↺</button>
        <button type="button" class="ask" aria-expanded={isAsked} aria-label={`about ${label}`}
          onClick={() => setAsked(!isAsked)}>?</button>
      </div>
      <LoopTrack name={name} />
      <Track name={name} sliderRange={sliderRange} value={value} units={units}>
        <input type="range" id={`slide-${id}`} min={fromSI(sliderRange.low, unit)}
          max={fromSI(sliderRange.high, unit)} step={sliderRange.step / (toSI(1, unit) - toSI(0, unit))}
          value={fromSI(at, unit)} aria-valuetext={spoken} aria-describedby={`price-${id}`}
          onInput={(event) => slide(event, false)} onChange={(event) => slide(event, true)} />
      </Track>
      <PriceLine name={name} id={id} row={row} />
      {message && <p class="message" id={`message-${id}`}>{message}</p>}
      {isAsked && <About name={name} label={label} />}
    </div>
  );
}

type Row = ReturnType<typeof rowOf>;

/** The content of a parameter's row. */
function rowOf(explorer: Explorer, name: string) {
  const sliderRange = explorer.sliderRange(name);
  const unit = explorer.unit(name);
  const value = explorer.value(name);
  const preset = explorer.defaultValue(name);
  const isSet = name in explorer.design.value.set;
  const isOfLaunch = name.startsWith('launch.') && firstOf(explorer.design.value).includes(name);
  const middle = (sliderRange.low + sliderRange.high) / 2;
  const isNumber = (place: number | null | undefined) => Number.isFinite(place);
  const refusal = explorer.refusal.value;
  return {
    sliderRange,
    unit,
    value,
    at: [value, preset, WHEN_UNSET[name]].find(isNumber) ?? middle,
    decimals: decimalsOf(sliderRange, unit),
    units: explorer.units.value,
    shown: shownOf(explorer, name),
    isSet,
    // without ball speed, launch angle or spin a launch is incomplete
    hasReset: isSet && !(isOfLaunch && preset === null),
    message: refusal?.parameters[0] === name ? refusal.message : null,
  };
}

/** The meaning of a parameter, and the source of its value. */
function About({ name, label }: { name: string; label: string }) {
  const { explorer } = usePage();
  const { owner, source } = defaultOf(name, explorer.design.value, explorer.catalog);
  return (
    <div class="about">
      <p>{explorer.parameter(name).doc} (<code>{name}</code>)</p>
      <p>Value of the {owner}: {source ?? 'no source'}.</p>
      <VarySwitch name={name} label={label} />
    </div>
  );
}

/** A switch that lets the best drive change the parameter. */
function VarySwitch({ name, label }: { name: string; label: string }) {
  const { explorer } = usePage();
  const { catalog } = explorer;
  const names = explorer.varied.value;
  const isVaried = names.includes(name);
  const isLast = isVaried && names.length === 1;
  const isDisabled = isLast || isIdle(name, explorer.design.value, catalog);
  const change = () => explorer.change(withVaried(explorer.state.value, catalog, name, !isVaried));
  return (
    <p>
      <label>
        <input type="checkbox" checked={isVaried} disabled={isDisabled} onChange={change} />
        {' '}the best drive may change the {label}
      </label>
    </p>
  );
}

function PriceLine({ name, id, row }: { name: string; id: string; row: Row }) {
  const { explorer } = usePage();
  const slope = explorer.slopes.value.get(name);
  const { at, units, unit, decimals, sliderRange } = row;
  const isUnset = row.value === null;
  const why = explorer.noSlope.value.get(name);
  if (!slope) return <p class="price" id={`price-${id}`}>{why ?? (isUnset ? 'not stated' : '\u00a0')}</p>;
  const { low, high } = bandOf(at, slope, LOSS[units]);
  const end = (value: number) => withUnit(digits(fromSI(value, unit), decimals), unit);
  const from = low <= sliderRange.low ? null : end(low);
  const to = high >= sliderRange.high ? null : end(high);
  const loss = units === 'us' ? '1 yd' : '1 m';
  const band = from && to ? `${digits(fromSI(low, unit), decimals)} to ${to}` : from ? `above ${from}` : to ? `below ${to}` : 'everywhere';
  return (
    <p class={`price ${explorer.driveMark.value}`} id={`price-${id}`}>
      <b>{priceOf(name, slope, unit, units).text}</b>
      <span title={`values that cost at most ${loss}`}>{isUnset ? ' · not stated' : ` · ≤ ${loss} lost: ${band}`}</span>
    </p>
  );
}

interface FieldProps {
  name: string;
  id: string;
  label: string;
  unit: string;
  /** The text of the state's number. */
  shown: string;
  hasMessage: boolean;
}

/**
 * The text of a field. A number typed in the unit of the field is shown as it was typed, a number
 * in another unit is converted. A text that the core has not read is shown as it was typed. The
 * field of an unset parameter is empty.
 */
function shownOf(explorer: Explorer, name: string): string {
  const text = explorer.design.value.set[name];
  const { unit, decimals } = explorer.field(name);
  const value = explorer.value(name);
  if (text === NONE || value === null) return '';
  if (!Number.isFinite(value)) return text ?? 'inf';
  const read = parts(text ?? '');
  if (read?.unit === unit) return String(read.number);
  return String(Number(fromSI(value, unit).toFixed(decimals + 1)));
}

/**
 * A text that is being typed. The field shows it until the text is committed, or until the text of
 * the state's number is no longer `instead`.
 */
interface Draft {
  instead: string;
  text: string;
}

function Field({ name, id, label, unit, shown, hasMessage }: FieldProps) {
  const { explorer } = usePage();
  const [draft, setDraft] = useState<Draft | null>(null);
  const commit = (event: Event) => {
    setDraft(null);
    const typed = (event.target as HTMLInputElement).value.trim().replace('−', '-');
    if (typed === shown) return;
    if (typed === '') {
      explorer.reset(name);
      return;
    }
    const read = parts(typed);
    explorer.set(name, read && read.unit === '' && unit !== '' ? `${typed} ${unit}` : typed);
  };
  const isDraft = draft?.instead === shown;
  return (
    <input type="text" class="number" inputMode="decimal" autoComplete="off" spellcheck={false}
      value={isDraft ? draft.text : shown} placeholder="–" data-draft={isDraft ? '' : undefined}
      aria-label={`${label}, ${unit || 'number'}`}
      aria-invalid={hasMessage} aria-describedby={hasMessage ? `message-${id}` : undefined}
      onInput={(event) => setDraft({ instead: shown, text: (event.target as HTMLInputElement).value })}
      onChange={commit} />
  );
}

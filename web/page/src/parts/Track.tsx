// The slider of a parameter with marks: its band (the values that cost little) and its best value.
import type { ComponentChildren } from 'preact';
import { bandOf, LOSS } from '../drive/price';
import type { SliderRange } from '../setup/slider';
import type { System } from '../setup/units';
import { usePage } from './context';

/** Half of the width of a slider's knob, pixels. */
export const KNOB = 8;

const place = (part: number) => `calc(${KNOB}px + ${part} * (100% - ${2 * KNOB}px))`;

interface Props {
  name: string;
  sliderRange: SliderRange;
  value: number | null;
  units: System;
  children: ComponentChildren;
}

export function Track({ name, sliderRange: { low, high }, value, units, children }: Props) {
  const { explorer } = usePage();
  const slope = explorer.slopes.value.get(name);
  const best = explorer.best.last?.values[name];
  const markClass = `best-mark ${explorer.best.mark.value}`;
  const bandClass = `band ${explorer.driveMark.value}`;
  const part = (x: number) => Math.min(1, Math.max(0, (x - low) / (high - low)));
  let band = null;
  if (slope && value !== null && Number.isFinite(value)) {
    const ends = bandOf(value, slope, LOSS[units]);
    const [from, to] = [part(ends.low), part(ends.high)];
    band = <span class={bandClass} style={{ left: place(from), width: `calc(${to - from} * (100% - ${2 * KNOB}px))` }} />;
  }
  return (
    <div class="track">
      {band}
      {children}
      {best !== undefined && <span class={markClass} title="best" style={{ left: place(part(best)) }} />}
    </div>
  );
}

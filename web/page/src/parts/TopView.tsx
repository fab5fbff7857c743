// The flight from above, at true scale, with a landing point to drag.
import { useMemo, useRef, useState } from 'preact/hooks';
import { landedOf } from '../drive/drive';
import { firstOf } from '../setup/design';
import { labelOf } from '../setup/parameters';
import { toSI } from '../setup/units';
import { usePage } from './context';
import { Figure } from './Figure';
import { inLength, length, lengthUnit, sideways, ticks } from './lengths';
import { Curve } from './Curve';
import { farthest, MARGIN } from './scale';
import { pathTable } from './SideView';
import { useWidth } from './size';
import { useSteady } from './steady';

/** Half of the smallest width of ground in the picture, m. */
const HALF_WIDTH = 22;
const FARTHEST_ASIDE = 60;

type Pair = readonly [string, string];

export function TopView() {
  const { explorer } = usePage();
  const units = explorer.units.value;
  const { ref, width } = useWidth();
  const isLaunch = explorer.isLaunch.value;
  const usual: Pair = isLaunch
    ? ['launch.launch_angle', 'launch.launch_direction'] : ['club.loft', 'swing.face_angle'];
  const [chosen, setChosen] = useState<Pair>(usual);
  const first = useSteady(() => firstOf(explorer.design.value));
  const pair = chosen.every((name) => first.includes(name)) ? chosen : usual;
  const flown = explorer.drive.last;
  const drive = landedOf(flown);
  const ghost = explorer.ghost.last;
  const { driveMark } = explorer;
  const distance = farthest([drive, ghost]);
  const scale = (width - MARGIN.left - MARGIN.right) / distance;
  const aside = [drive, ghost].flatMap((each) =>
    [...(each?.path ?? []), ...(each?.roll ?? [])].map(({ right }) => Math.abs(right)));
  // round up to steps, so that the picture seldom changes its height
  const half = Math.ceil(Math.max(HALF_WIDTH, ...aside) / 12) * 12;
  const x = (downrange: number) => MARGIN.left + downrange * scale;
  const y = (right: number) => MARGIN.top + (half + right) * scale;
  const plan = `${scale} ${half}`;
  const height = 2 * half * scale + MARGIN.top + MARGIN.bottom;
  const { carry = NaN, lateral = NaN } = drive?.outcomes ?? {};
  const sentence = drive
    ? `The ball lands at ${length(carry, units)}, ${sideways(lateral, units)}.`
    : flown?.message ?? 'No drive yet.';
  const unit = lengthUnit(units);
  const aim = (downrange: number, right: number) => explorer.aim(pair, downrange, right);
  // compute the scales only when they change: most moves of a slider do not change them
  const scales = useMemo(() => (
    <>
      {ticks(0, inLength(distance, units), Math.max(3, width / 110)).map((tick) => (
        <g key={tick}>
          <line class="grid" x1={x(toSI(tick, unit))} x2={x(toSI(tick, unit))} y1={y(-half)} y2={y(half)} />
          <text class="tick" x={x(toSI(tick, unit))} y={height - 14} text-anchor="middle">{tick}</text>
        </g>
      ))}
      {ticks(-inLength(half, units), inLength(half, units), 5).map((tick) => (
        <text class="tick" key={tick} x={MARGIN.left - 6} y={y(toSI(tick, unit)) + 4} text-anchor="end">
          {tick === 0 ? 0 : `${Math.abs(tick)} ${tick > 0 ? 'R' : 'L'}`}
        </text>
      ))}
      <line class="ground" x1={x(0)} x2={x(distance)} y1={y(0)} y2={y(0)} />
    </>
  ), [width, distance, half, units]);
  return (
    <Figure name="top" title="View from above" sentence={sentence} mark={driveMark} table={() => pathTable(drive, unit)} place={ref}
      below={<Aim names={first} pair={pair} onPair={setChosen} carry={carry} lateral={lateral} onAim={aim} />}>
      <svg class={driveMark} width={width} height={height} role="img" aria-label={`View from above. ${sentence}`}>
        {scales}
        <g class={explorer.ghost.mark}>
          {ghost && <Curve drive={ghost} name="ghost" axis="right" x={x} y={y} scale={plan} />}
        </g>
        {drive && <Curve drive={drive} name="yours" axis="right" x={x} y={y} scale={plan} />}
        {drive && (
          <Handle x={x(carry)} y={y(lateral)}
            onMove={(from, dx, dy) => aim(from.carry + dx / scale, from.lateral + dy / scale)}
            landing={{ carry, lateral }} />
        )}
      </svg>
    </Figure>
  );
}

interface Landing {
  carry: number;
  lateral: number;
}

interface HandleProps {
  x: number;
  y: number;
  landing: Landing;
  /**
   * Called with the landing at the start of the drag, and how far the pointer has moved since then.
   */
  onMove: (from: Landing, dx: number, dy: number) => Promise<void>;
}

/** The landing point, to drag. The sliders below move it by keyboard. */
function Handle({ x, y, landing, onMove }: HandleProps) {
  const { explorer } = usePage();
  const last = useRef(Promise.resolve());
  const begin = useRef({ x: 0, y: 0, landing });
  const move = (event: PointerEvent) => {
    const handle = event.currentTarget as SVGGElement;
    if (!handle.hasPointerCapture(event.pointerId)) return;
    const { x: fromX, y: fromY, landing: from } = begin.current;
    // use the displacement of the pointer: the scale of the picture may change during the drag
    last.current = onMove(from, event.clientX - fromX, event.clientY - fromY);
  };
  const take = (event: PointerEvent) => {
    event.preventDefault();
    begin.current = { x: event.clientX, y: event.clientY, landing };
    (event.currentTarget as SVGGElement).setPointerCapture(event.pointerId);
  };
  const release = () => void last.current.then(() => explorer.release());
  return (
    <g class="handle" onPointerDown={take} onPointerMove={move} onPointerUp={release} onPointerCancel={release}>
      <circle class="reach" cx={x} cy={y} r={20} />
      <circle class="yours" cx={x} cy={y} r={7} />
    </g>
  );
}

interface AimProps {
  names: readonly string[];
  pair: Pair;
  onPair: (pair: Pair) => void;
  carry: number;
  lateral: number;
  onAim: (carry: number, lateral: number) => Promise<void>;
}

function Aim(props: AimProps) {
  const { explorer } = usePage();
  const [isOpen, setOpen] = useState(false);
  return (
    <>
      {explorer.aimMessage.current && <p class="message" role="status">{explorer.aimMessage.current}</p>}
      <details class="aim" onToggle={(event) => setOpen(event.currentTarget.open)}>
        <summary>aim: move the landing point</summary>
        {isOpen && <AimSliders {...props} />}
      </details>
    </>
  );
}

function AimSliders({ names, pair, onPair, carry, lateral, onAim }: AimProps) {
  const { explorer } = usePage();
  const units = explorer.units.value;
  const last = useRef(Promise.resolve());
  const unit = lengthUnit(units);
  const longest = Math.max(320, carry || 0);
  const slider = (label: string, value: number, low: number, high: number, to: (metres: number) => Promise<void>) => (
    <label>
      {label}
      <input type="range" min={inLength(low, units)} max={inLength(high, units)} step={0.5}
        disabled={Number.isNaN(value)}
        value={inLength(value || 0, units)} aria-valuetext={length(value, units)}
        onInput={(event) => { last.current = to(toSI(Number(event.currentTarget.value), unit)); }}
        onChange={() => void last.current.then(() => explorer.release())} />
    </label>
  );
  const select = (at: 0 | 1) => (
    <select aria-label={`parameter ${at + 1} of the aim`} value={pair[at]}
      onChange={(event) => {
        const name = event.currentTarget.value;
        const other = pair[1 - at]!;
        if (name !== other) onPair(at === 0 ? [name, other] : [other, name]);
      }}>
      {names.map((name) => <option value={name} key={name}>{labelOf(name)}</option>)}
    </select>
  );
  return (
    <>
      <p>Drag the landing point, or use these sliders; {select(0)} and {select(1)} follow.</p>
      {slider('carry', carry, 100, longest, (metres) => onAim(metres, lateral))}
      {slider('lateral', lateral, -FARTHEST_ASIDE, FARTHEST_ASIDE, (metres) => onAim(carry, metres))}
    </>
  );
}

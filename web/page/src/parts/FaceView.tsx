// The strike point on the face, to drag. The two strike sliders move it by keyboard.
import { useComputed } from '@preact/signals';
import { withValues } from '../setup/design';
import { digits, fromSI, textOf } from '../setup/units';
import { usePage } from './context';
import { Figure } from './Figure';

/** Half of the width and height of the face that is drawn, m. */
const HALF = [0.05, 0.028] as const;
/** Pixels per metre. */
const SCALE = 2200;
const WIDTH = 2 * HALF[0] * SCALE + 20;
const HEIGHT = 2 * HALF[1] * SCALE + 20;

/** A strike outside of the picture is drawn at its edge. */
const inside = (pixel: number, end: number) => Math.min(end, Math.max(0, pixel));

export function FaceView() {
  const { explorer } = usePage();
  const toe = useComputed(() => explorer.value('strike.toe') ?? 0).value;
  const high = useComputed(() => explorer.value('strike.high') ?? 0).value;
  if (Number.isNaN(toe) || Number.isNaN(high)) return null;
  // looked at from the front, a right-hander's toe is to the left
  const [x, y] = [
    inside(WIDTH / 2 - toe * SCALE, WIDTH),
    inside(HEIGHT / 2 - high * SCALE, HEIGHT),
  ];
  const move = (event: PointerEvent, isFinal: boolean) => {
    const svg = event.currentTarget as SVGSVGElement;
    if (!svg.hasPointerCapture(event.pointerId) && event.type !== 'pointerdown') return;
    const box = svg.getBoundingClientRect();
    const scale = WIDTH / box.width;
    const point = [
      (WIDTH / 2 - (event.clientX - box.left) * scale) / SCALE,
      (HEIGHT / 2 - (event.clientY - box.top) * scale) / SCALE,
    ] as const;
    const [toTheToe, above] = point.map((metres, axis) => {
      const name = axis === 0 ? 'strike.toe' : 'strike.high';
      const { low, high: most } = explorer.sliderRange(name);
      return textOf(Math.min(most, Math.max(low, metres)), 'mm', 1);
    });
    explorer.changeDesign(withValues(
      explorer.design.value, { 'strike.toe': toTheToe, 'strike.high': above }), isFinal);
  };
  const take = (event: PointerEvent) => {
    (event.currentTarget as SVGSVGElement).setPointerCapture(event.pointerId);
    move(event, false);
  };
  const millimetres = (metres: number) => digits(fromSI(metres, 'mm'), 1);
  const sentence = `The ball is struck ${millimetres(Math.abs(toe))} mm towards the ${toe < 0 ? 'heel' : 'toe'}, `
    + `${millimetres(Math.abs(high))} mm ${high < 0 ? 'below' : 'above'} the sweet spot.`;
  const table = () => ({
    head: ['strike', 'value [mm]'],
    rows: [['to toe', millimetres(toe)], ['high', millimetres(high)]],
  });
  return (
    <Figure name="face-view" title="Face" sentence={sentence} table={table}>
      <svg class="face" viewBox={`0 0 ${WIDTH} ${HEIGHT}`} role="img" aria-label={`Strike point on the face. ${sentence}`}
        onPointerDown={take} onPointerMove={(event) => move(event, false)}
        onPointerUp={() => explorer.release()} onPointerCancel={() => explorer.release()}>
        <rect class="head" x={10} y={10} width={WIDTH - 20} height={HEIGHT - 20} rx={48} />
        <line class="grid" x1={WIDTH / 2} x2={WIDTH / 2} y1={12} y2={HEIGHT - 12} />
        <line class="grid" x1={12} x2={WIDTH - 12} y1={HEIGHT / 2} y2={HEIGHT / 2} />
        <text class="tick" x={22} y={HEIGHT / 2 - 5}>toe</text>
        <text class="tick" x={WIDTH - 22} y={HEIGHT / 2 - 5} text-anchor="end">heel</text>
        <circle class="yours" cx={x} cy={y} r={7} />
      </svg>
    </Figure>
  );
}

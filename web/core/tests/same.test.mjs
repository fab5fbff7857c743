// Compares the core with the program: numbers, statuses and messages are equal.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { randomSetup, run, start, wordsOf } from './common.mjs';
import { random } from './random.mjs';

const core = await start();
const next = random(56);
const setups = Array.from({ length: 100 }, () => randomSetup(next));

/** The largest difference, as a fraction of the size of the outcome. */
const ROUNDING = 1e-12;

/**
 * The largest difference of second derivatives of the total: each bounce amplifies the rounding
 * error of the bounce before.
 */
const ROUNDING_OF_BOUNCES = 1e-11;

/** The optimizer's tolerance: a gradient that vanishes at an optimum has an error of this size. */
const KKT = 1e-10;

/** The words of a text in one line: standard error breaks its lines between words. */
const inLine = text => text.replace(/\s+/g, ' ').trim();

/**
 * A message of the program with arguments and commands named as the core names them. The usage of a
 * command is that of its command line.
 */
function inPageWords(text) {
  if (text.includes('Usage:')) return text;
  return text
    .replace(/--set ([a-z_.]+)=/g, '$1 = ')
    .replace(/--([a-z]+(?:-[a-z]+)*)/g, (_, option) => option.replaceAll('-', ' '))
    .replace(/'longdrive ([a-z-]+)'/g, '"$1"');
}

/** A text without the digits of a KKT residual, which is a rounding error at an optimum. */
const steady = text => text.replace(/(KKT residual) [\d.e-]+/, '$1');

/** The answers of core and program to a command. Asserts that exit status and messages are equal. */
function both(command, setup, ...more) {
  const words = [command, ...wordsOf(setup), ...more, '--json'];
  const theirs = run(words);
  const ours = core.ask({ words }).head;
  const about = words.join(' ');
  assert.equal(ours.exit, theirs.status, about);
  const said = ours.said.map(({ kind, text }) => (kind === 'note' || kind === 'usage' ? text : `${kind}: ${text}`));
  assert.equal(inLine(said.join('\n')), inPageWords(inLine(theirs.stderr)), about);
  return { ours: JSON.parse(ours.answer), theirs: JSON.parse(theirs.stdout), about };
}

/** Compares all parts of two answers; `size` returns the largest allowed difference of two numbers. */
function compare(ours, theirs, size, about, place = []) {
  const where = `${about}: ${place.join('.')}`;
  if (typeof ours === 'number' && typeof theirs === 'number') {
    const most = size(place, Math.max(Math.abs(ours), Math.abs(theirs)));
    assert.ok(Math.abs(ours - theirs) <= most, `${where}: ${ours} and ${theirs}`);
    return;
  }
  if (typeof ours === 'string' && typeof theirs === 'string') {
    assert.equal(steady(ours), steady(inPageWords(theirs)), where);
    return;
  }
  if (ours === null || theirs === null || typeof ours !== 'object') {
    assert.equal(ours, theirs, where);
    return;
  }
  assert.deepEqual(Object.keys(ours), Object.keys(theirs), where);
  for (const key of Object.keys(ours)) compare(ours[key], theirs[key], size, about, [...place, key]);
}

test('same drives as the program', () => {
  for (const setup of setups) {
    const { ours, theirs, about } = both('simulate', setup);
    compare(ours, theirs, (_, number) => ROUNDING * number, about);
  }
});

test('same gradients and Hessians as the program', () => {
  for (const setup of setups) {
    const { ours, theirs, about } = both('gradient', setup, '--hessian', '--of', 'carry,lateral,total,apex_height,spin');
    // a derivative of an outcome may be a sum of terms as large as the largest derivative of this
    // outcome, and then has the rounding error of these terms
    const sizes = theirs.outcomes.map(({ value, gradient, hessian }) =>
      Math.max(...[value, ...Object.values(gradient ?? {}), ...(hessian?.values.flat() ?? [])].map(Math.abs)));
    const size = ([, k, order], number) => {
      const bounces = order === 'hessian' && theirs.outcomes[k].of === 'total';
      return (bounces ? ROUNDING_OF_BOUNCES : ROUNDING) * Math.max(sizes[k] ?? 0, number);
    };
    compare(ours, theirs, size, about);
  }
});

test('same optima as the program', () => {
  for (const setup of setups) {
    const { ours, theirs, about } = both('optimize', setup);
    const carry = Math.abs(theirs.value);
    const size = ([key], number) => (key === 'kkt_residual' ? KKT : (key === 'gradient' ? KKT : ROUNDING) * Math.max(carry, number));
    compare(ours, theirs, size, about);
  }
});

test('same messages as the program for bad input', () => {
  const lines = [
    ['simulate', 'tour'],
    ['simulate', 'nothing.toml'],
    ['simulate', '--set', 'club.lofft=10deg'],
    ['simulate', '--set', 'club.loft=10'],
    ['simulate', '--set', 'club.loft=95deg'],
    ['simulate', '--set', 'club.loft=10 degg', '--json'],
    ['simulate', '--set', 'strike.toe=200mm', '--json'],
    ['simulate', '--set', 'club.loft=-60deg', '--json'],
    ['simulate', '--launch', 'ball_speed=160mph'],
    ['simulate', '--speeed', '95mph'],
    ['gradient', '--of', 'cary', '--json'],
    ['optimize', '--vary', 'club.loft=20deg..4deg'],
    ['optimize', '--subject-to', 'apex_height < 3 s'],
    ['optimize', '--maximize', 'carry', '--minimize', 'spin', '--json'],
    ['optimize', '--vary', 'club.loft=4deg..20deg', '--subject-to', 'carry > 500 m', '--json'],
    ['plot', 'contour'],
    ['fly', 'tour-average'],
    ['nonsense'],
  ];
  for (const words of lines) {
    const theirs = run(words);
    const { exit, said, answer } = core.ask({ words }).head;
    const about = words.join(' ');
    assert.equal(exit, theirs.status, about);
    const text = said.map(({ kind, text: words }) => (kind === 'note' || kind === 'usage' ? words : `${kind}: ${words}`));
    assert.equal(inLine(text.join('\n')), inPageWords(inLine(theirs.stderr)), about);
    assert.equal(answer === '', theirs.stdout === '', about);
    if (answer) compare(JSON.parse(answer), JSON.parse(theirs.stdout), () => 0, about);
  }
});

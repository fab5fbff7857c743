// A design as arguments of the command line.
import type { Design } from './design';
import { hasLaunch, isReplaced } from './design';
import type { Parameter } from './parameters';
import type { SliderRange } from './slider';
import { compact, textOf } from './units';

export function settingsOf(design: Design, option = '--set'): string[] {
  const isLaunch = hasLaunch(design);
  // leave out replaced parameters: the program refuses settings of a club that strikes no ball
  return Object.entries(design.set).filter(([name]) => !isReplaced(name, isLaunch))
    .flatMap(([name, text]) => [option, `${name}=${text}`]);
}

export const setupWords = (design: Design) => [design.preset, ...settingsOf(design)];

/** The argument of a range: club.loft=4deg..20deg. */
export function rangeWords({ parameter, shown_in }: Parameter, { low, high }: SliderRange): string {
  const [from, to] = [low, high].map((end) => compact(textOf(end, shown_in, 6)));
  return `${parameter}=${from}..${to}`;
}

/** Quotes a word that a shell would change. */
function quoted(word: string): string {
  return /^[\w./:=,+-]+$/.test(word) ? word : `'${word.replace(/'/g, `'\\''`)}'`;
}

/** A command to type. */
export const commandLine = (words: readonly string[]) =>
  ['longdrive', ...words.map((word) => quoted(compactSetting(word)))].join(' ');

const compactSetting = (word: string) =>
  word.replace(/^([\w.]+=)([-+.\de]+) ([\w/^]+)$/i, '$1$2$3');

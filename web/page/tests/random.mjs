// Random input, the same in each run: mutations of valid input.
import { random } from '../../core/tests/random.mjs';

const NUMBERS = ['0', '-0', '1e308', '-1e308', '1e999', '1e-320', 'NaN', 'inf', '-inf', '9'.repeat(400), '0x10', '1_000', '½', '١٢', '10,5', '.', '-', '+', ''];
const SCRAPS = ['\u0000', '\n', '\r', '\t', '"', "'", '\\', '<script>alert(1)</script>', '%', '%00', '%E0%A4%A', '%25', '&', '&&', '=', '==', '#', ',', ';', '𝒳', '\ud800', '\ufeff', '__proto__', 'constructor', '[', ']]', '{', '\u202e', ' '.repeat(300)];

/** Random choices. */
export class Chance {
  #next;

  constructor(seed) {
    this.#next = random(seed);
  }

  below(count) {
    return Math.floor(this.#next() * count);
  }

  pick(list) {
    return list[this.below(list.length)];
  }

  /** True with this probability. */
  is(probability) {
    return this.#next() < probability;
  }

  bytes(length) {
    return Uint8Array.from({ length }, () => this.below(256));
  }

  text(length) {
    return String.fromCharCode(...Array.from({ length }, () => (this.is(0.8) ? this.below(128) : this.below(65536))));
  }

  /** A text with a few changes. */
  mutated(text, parts) {
    let changed = text;
    do changed = this.#changed(changed, parts); while (this.is(0.3));
    return changed;
  }

  #changed(text, { separator, known }) {
    const at = this.below(text.length + 1);
    const rows = text.split(separator);
    const row = this.below(rows.length);
    const joined = () => rows.join(separator);
    switch (this.below(9)) {
      case 0: return text.slice(0, at) + text.slice(at + 1 + this.below(8));
      case 1: return text.slice(0, at) + this.pick(SCRAPS) + text.slice(at);
      case 2: return text.replace(/[-+]?\d[\d.]*/g, number => (this.is(0.1) ? this.pick(NUMBERS) : number));
      case 3: rows.splice(row, 0, this.pick(rows)); return joined();
      case 4: rows.splice(row, 1); return joined();
      case 5: rows.splice(row, 0, this.pick(known)); return joined();
      case 6: rows.reverse(); return joined();
      case 7: return text.slice(0, at) + this.text(this.below(12)) + text.slice(at);
      default: rows[row] = this.mutatedName(rows[row]); return joined();
    }
  }

  /** A row with a changed letter, so that its name is unknown. */
  mutatedName(row) {
    return row.replace(/[a-z]/, letter => this.pick(['x', letter.toUpperCase(), `${letter}${letter}`, '.']));
  }
}

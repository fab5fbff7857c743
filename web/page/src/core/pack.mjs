// Bytes as the text of an HTML file in windows-1252, where each byte is a character. Four bytes
// that HTML would change or interpret are escaped. The text is 1.6 % larger than the bytes; base64
// would be 33 % larger.

const ESCAPE = 0x3d;
/** NUL, carriage return, '<' and '='. */
const ESCAPED = [0x00, 0x0d, 0x3c, ESCAPE];
/** The offset that is added to an escaped byte. */
const SHIFT = 0x40;

/**
 * Bytes for a file.
 * @param {Uint8Array} bytes
 * @returns {Uint8Array}
 */
export function pack(bytes) {
  const packed = [];
  for (const byte of bytes) {
    if (ESCAPED.includes(byte)) packed.push(ESCAPE, byte + SHIFT);
    else packed.push(byte);
  }
  return Uint8Array.from(packed);
}

/**
 * Bytes of a text that was read as windows-1252.
 * @param {string} text
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function unpack(text) {
  const byteOf = new Uint8Array(0x10000);
  new TextDecoder('windows-1252').decode(Uint8Array.from({ length: 256 }, (_, byte) => byte)).split('')
    .forEach((character, byte) => { byteOf[character.charCodeAt(0)] = byte; });
  const bytes = new Uint8Array(text.length);
  let length = 0;
  for (let at = 0; at < text.length; at += 1) {
    let byte = byteOf[text.charCodeAt(at)] ?? 0;
    if (byte === ESCAPE) {
      at += 1;
      byte = (byteOf[text.charCodeAt(at)] ?? 0) - SHIFT;
    }
    bytes[length] = byte;
    length += 1;
  }
  return bytes.slice(0, length);
}

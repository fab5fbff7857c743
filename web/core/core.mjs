// The JavaScript side of the core: README.md has the layout of a message.

/** Size of a length field, bytes. */
const LENGTH = 4;

const encoder = new TextEncoder();
const decoder = new TextDecoder();

/**
 * A request as JSON, without the contents of files.
 * @typedef {Record<string, unknown>} Request
 */

/**
 * An answer: `head` is its JSON, `block` has its numbers.
 * @typedef {{ head: any, block: Float64Array }} Numbers
 */

/**
 * WASI of Node or of a browser.
 * @typedef {{ wasiImport: any, initialize(instance: any): unknown }} Wasi
 */

/** longdrive, compiled to WebAssembly. */
export class Core {
  /** @type {any} */
  #exports;

  /** @param {WebAssembly.Instance} instance */
  constructor(instance) {
    this.#exports = instance.exports;
  }

  /**
   * Makes an instance of the compiled module.
   * @param {WebAssembly.Module} module
   * @param {Wasi} wasi
   * @param {(done: number, of: number) => void} [progress] receives the completed parts and all parts of a long command
   * @returns {Promise<Core>}
   */
  static async start(module, wasi, progress = () => {}) {
    const instance = await WebAssembly.instantiate(module, { wasi_snapshot_preview1: wasi.wasiImport, page: { progress } });
    wasi.initialize(instance);
    return new Core(instance);
  }

  /**
   * Runs a command of the program with files in memory.
   * @param {Request} request
   * @param {Record<string, Uint8Array>} [files]
   * @returns {{ head: any, files: Record<string, Uint8Array> }}
   */
  ask(request, files = {}) {
    const contents = Object.entries(files);
    const named = contents.map(([name, content]) => ({ name, bytes: content.length }));
    const { head, bytes } = this.#call('ask', { ...request, files: named }, contents.map(([, content]) => content));
    /** @type {Record<string, Uint8Array>} */
    const written = {};
    let at = 0;
    for (const file of head.files ?? []) {
      written[file.name] = bytes.slice(at, at += file.bytes);
    }
    return { head, files: written };
  }

  /**
   * One drive with derivatives and path.
   * @param {Request} request
   * @returns {Numbers}
   */
  drive(request) {
    return this.#numbers('drive', request);
  }

  /**
   * Outcomes over two parameters.
   * @param {Request} request
   * @returns {Numbers}
   */
  map(request) {
    return this.#numbers('map', request);
  }

  /**
   * The values of two parameters with which the ball lands at a point.
   * @param {Request} request
   * @returns {Numbers}
   */
  aim(request) {
    return this.#numbers('aim', request);
  }

  /**
   * The while-loop of the MAE 494 report beside the exact drive.
   * @param {Request} request
   * @returns {Numbers}
   */
  loop(request) {
    return this.#numbers('loop', request);
  }

  /**
   * The longest step of the integration with which drives are accurate.
   * @param {Request} request
   * @returns {any} the head
   */
  step(request) {
    return this.#call('step', request, []).head;
  }

  /**
   * The iterations of the search for the best drive.
   * @param {Request} request
   * @returns {Numbers}
   */
  iterations(request) {
    return this.#numbers('iterations', request);
  }

  /**
   * @param {string} endpoint
   * @param {Request} request
   * @returns {Numbers}
   */
  #numbers(endpoint, request) {
    const { head, bytes } = this.#call(endpoint, request, []);
    return { head, block: new Float64Array(bytes.buffer) };
  }

  /**
   * @param {string} endpoint
   * @param {Request} request
   * @param {Uint8Array[]} contents
   * @returns {{ head: any, bytes: Uint8Array }}
   */
  #call(endpoint, request, contents) {
    const head = encoder.encode(JSON.stringify({ [endpoint]: request }));
    const block = contents.reduce((sum, content) => sum + content.length, 0);
    const length = 2 * LENGTH + head.length + block;
    const address = this.#exports.input(length);
    const lengths = new DataView(this.#memory, address, 2 * LENGTH);
    lengths.setUint32(0, head.length, true);
    lengths.setUint32(LENGTH, block, true);
    const place = new Uint8Array(this.#memory, address, length);
    let at = 2 * LENGTH;
    for (const part of [head, ...contents]) {
      place.set(part, at);
      at += part.length;
    }
    this.#exports.answer();
    return this.#answer();
  }

  /** @returns {{ head: any, bytes: Uint8Array }} */
  #answer() {
    const address = this.#exports.output();
    const lengths = new DataView(this.#memory, address, 2 * LENGTH);
    const begin = address + 2 * LENGTH;
    const end = begin + lengths.getUint32(0, true);
    const head = JSON.parse(decoder.decode(new Uint8Array(this.#memory, begin, end - begin)));
    // a copy: the next call may move the memory
    const bytes = new Uint8Array(this.#memory.slice(end, end + lengths.getUint32(LENGTH, true)));
    return { head, bytes };
  }

  /**
   * The memory of the instance, read at each use, because growth replaces the buffer.
   * @returns {ArrayBuffer}
   */
  get #memory() {
    return this.#exports.memory.buffer;
  }
}

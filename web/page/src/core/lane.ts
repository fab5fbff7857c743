// A worker with a queue. The worker does one job at a time. At most one job of each topic waits: a
// newer job replaces it, and its answer is then null. The thread starts at once, but jobs wait
// until the worker has the core.
import workerCode from 'virtual:worker';
import type { Packed } from './load';
import type { Call, Command, FromWorker, Numbers, Reply, ToWorker } from './messages';

interface Job {
  topic: string;
  work: { kind: 'calls'; calls: Call[] } | { kind: 'command'; command: Command };
  settle: (answer: Answer | null) => void;
}

type Answer = { numbers: Numbers[] } | { reply: Reply };

/** The progress of long work: parts done, and all parts. */
export interface Progress {
  done: number;
  of: number;
}

/** Number of consecutive traps without an answer, after which a worker is not restarted. */
const MOST_TRAPS = 5;

export class Lane {
  #core: Packed | WebAssembly.Module | null = null;
  #hasStarted = false;
  #worker = this.#begin();
  #waiting: Job[] = [];
  #current: { job: Job; number: number } | null = null;
  #number = 0;
  /** Number of traps since the last answer of the worker. */
  #traps = 0;
  /** Resolve or reject the promise of `start`. */
  #onStart = { started: (_: WebAssembly.Module) => {}, failed: (_: Error) => {} };
  /** Receives the message of a trap, after which the worker is restarted. */
  onTrap: (message: string) => void = () => {};
  /** Called when no work is running or waiting. */
  onIdle: () => void = () => {};
  /** Receives the progress of long work; null when it ends. */
  onProgress: (progress: Progress | null) => void = () => {};

  /**
   * Gives the core to the worker. The promise resolves to the compiled core, or is rejected if the
   * worker cannot start the core.
   */
  start(core: Packed | WebAssembly.Module): Promise<WebAssembly.Module> {
    this.#core = core;
    this.#post(this.#worker, { kind: 'start', core });
    return new Promise((started, failed) => {
      this.#onStart = { started, failed };
    });
  }

  /** The answers to the calls; null if newer calls of the topic replaced these. */
  async calls(topic: string, calls: Call[]): Promise<Numbers[] | null> {
    const answer = await this.#queue(topic, { kind: 'calls', calls });
    return answer && 'numbers' in answer ? answer.numbers : null;
  }

  /** The answer to one call; null if newer calls of the topic replaced it. */
  async call(topic: string, call: Call): Promise<Numbers | null> {
    const answers = await this.calls(topic, [call]);
    return answers?.[0] ?? null;
  }

  /**
   * The answer to a command; null if a newer command of the topic replaced this command, or if this
   * command was ended.
   */
  async command(topic: string, words: string[], files: Record<string, Uint8Array> = {}) {
    const answer = await this.#queue(topic, { kind: 'command', command: { words, files } });
    return answer && 'reply' in answer ? answer.reply : null;
  }

  /**
   * Ends the job of a topic. A job that runs is ended with its thread, and a new thread starts: the
   * job cannot see a stop flag, because the thread shares no memory with the page.
   */
  end(topic: string) {
    if (this.#current?.job.topic === topic) {
      this.#restart();
      return;
    }
    const ended = this.#waiting.filter((job) => job.topic === topic);
    this.#waiting = this.#waiting.filter((job) => job.topic !== topic);
    for (const job of ended) job.settle(null);
  }

  get isIdle() {
    return this.#current === null && this.#waiting.length === 0;
  }

  #begin(): Worker {
    const address = URL.createObjectURL(new Blob([workerCode], { type: 'text/javascript' }));
    const worker = new Worker(address);
    worker.addEventListener('message', ({ data }: MessageEvent<FromWorker>) => {
      // a worker that was ended may still have messages on the way
      if (worker === this.#worker) this.#receive(data);
    });
    worker.addEventListener('error', (event) => {
      event.preventDefault();
      if (worker === this.#worker) this.#trap(event.message || 'the worker cannot start');
    });
    if (this.#core) this.#post(worker, { kind: 'start', core: this.#core });
    return worker;
  }

  #post(worker: Worker, message: ToWorker) {
    worker.postMessage(message);
  }

  #queue(topic: string, work: Job['work']): Promise<Answer | null> {
    return new Promise((settle) => {
      const replaced = this.#waiting.findIndex((job) => job.topic === topic);
      const job = { topic, work, settle };
      if (replaced >= 0) {
        this.#waiting[replaced]?.settle(null);
        this.#waiting[replaced] = job;
      } else {
        this.#waiting.push(job);
      }
      this.#next();
    });
  }

  #next() {
    if (this.#current || !this.#hasStarted) return;
    const job = this.#waiting.shift();
    if (!job) {
      this.onIdle();
      return;
    }
    this.#number += 1;
    this.#current = { job, number: this.#number };
    this.#post(this.#worker, { ...job.work, number: this.#number });
  }

  #receive(message: FromWorker) {
    if (message.kind === 'started') {
      this.#core = message.module;
      this.#hasStarted = true;
      this.#onStart.started(message.module);
      this.#next();
      return;
    }
    if (message.kind === 'progress') {
      this.onProgress({ done: message.done, of: message.of });
      return;
    }
    if (message.kind === 'trap') {
      this.#trap(message.message);
      return;
    }
    const current = this.#current;
    if (!current || current.number !== message.number) return;
    this.#current = null;
    this.#traps = 0;
    this.onProgress(null);
    current.job.settle(message);
    this.#next();
  }

  #trap(message: string) {
    this.#traps += 1;
    // without a compiled core, do not restart: the core is missing, or the browser cannot run it
    const hasCore = this.#core instanceof WebAssembly.Module;
    if (hasCore) this.onTrap(message);
    if (hasCore && this.#traps < MOST_TRAPS) {
      this.#restart();
      return;
    }
    this.#worker.terminate();
    this.#onStart.failed(new Error(message));
    for (const job of [this.#current?.job, ...this.#waiting]) job?.settle(null);
    this.#current = null;
    this.#waiting = [];
    this.onIdle();
  }

  #restart() {
    this.#worker.terminate();
    this.#hasStarted = false;
    const current = this.#current;
    this.#current = null;
    this.#worker = this.#begin();
    this.onProgress(null);
    current?.job.settle(null);
    this.#next();
  }
}

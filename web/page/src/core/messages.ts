// Messages between the page and its workers.
import type { Packed } from './load';

/** The parts that all requests of calls have: the setup, and the units of messages. */
export interface RequestBase {
  setup: { preset: string; set: Readonly<Record<string, unknown>> };
  units: string;
}

/** A function of the core that answers with numbers, and its request. */
export interface Call {
  endpoint: 'drive' | 'map' | 'aim' | 'loop' | 'iterations';
  request: RequestBase & Record<string, unknown>;
}

/** A command of the program, with its input files. */
export interface Command {
  words: string[];
  files: Record<string, Uint8Array>;
}

/** Messages to a worker: first the core, packed or compiled, then numbered work. */
export type ToWorker =
  | { kind: 'start'; core: Packed | WebAssembly.Module }
  | { kind: 'calls'; number: number; calls: Call[] }
  | { kind: 'command'; number: number; command: Command };

/** The numbers of one call. */
export interface Numbers {
  head: Head;
  block: Float64Array;
}

/** The JSON of one call; its keys depend on the function. */
export interface Head {
  status: string;
  message?: string | null;
  parameters?: string[];
  [key: string]: unknown;
}

/** The answer to a command. */
export interface Reply {
  exit: number;
  answer: string;
  said: { kind: string; text: string }[];
  files: Record<string, Uint8Array>;
}

/** Messages from a worker. */
export type FromWorker =
  | { kind: 'started'; module: WebAssembly.Module }
  | { kind: 'numbers'; number: number; numbers: Numbers[]; milliseconds: number }
  | { kind: 'reply'; number: number; reply: Reply }
  | { kind: 'progress'; done: number; of: number }
  | { kind: 'trap'; number: number; message: string };

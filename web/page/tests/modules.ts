// The modules of the page that read external input, for tests under Node.
export * from '../src/core/lane';
export * from '../src/drive/drive';
export * from '../src/parts/lengths';
export * from '../src/setup/design';
export * from '../src/setup/file';
export * from '../src/setup/parameters';
export * from '../src/setup/slider';
export * from '../src/setup/units';
export * from '../src/setup/words';
export * from '../src/state/best';
export * from '../src/state/explorer';
export * from '../src/state/fragment';
export * from '../src/state/state';

// The modules of the page that tests run under Node.
export { designOf, writeSetup } from '../src/setup/file';
export { Catalog } from '../src/setup/parameters';
export { setupWords } from '../src/setup/words';
export { read, write } from '../src/state/fragment';

// Values that every component reads.
import { createContext } from 'preact';
import { useContext } from 'preact/hooks';
import type { Address } from '../state/address';
import type { Explorer } from '../state/explorer';

export interface Page {
  explorer: Explorer;
  address: Address;
}

export const PageContext = createContext<Page | null>(null);

export function usePage(): Page {
  const page = useContext(PageContext);
  if (!page) throw new Error('no page');
  return page;
}

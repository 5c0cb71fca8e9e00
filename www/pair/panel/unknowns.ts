/** The five unknowns of the relative orientation. */
import type { FiveParameters } from '../../shared/crate';

export interface Unknown {
  field: keyof FiveParameters;
  symbol: string;
  unit: string;
  /** Decimals where no standard error says how many count. */
  digits: number;
}

export const UNKNOWNS: readonly Unknown[] = [
  { field: 'omega_deg', symbol: 'ω', unit: '°', digits: 4 },
  { field: 'phi_deg', symbol: 'φ', unit: '°', digits: 4 },
  { field: 'kappa_deg', symbol: 'κ', unit: '°', digits: 4 },
  { field: 'by_mm', symbol: 'by', unit: 'mm', digits: 4 },
  { field: 'bz_mm', symbol: 'bz', unit: 'mm', digits: 4 },
];

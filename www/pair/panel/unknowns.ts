/** The five unknowns of the relative orientation, and what the paper printed for them. */
import type { FiveParameters } from '../../shared/crate';

export interface Unknown {
  field: keyof FiveParameters;
  symbol: string;
  unit: string;
  digits: number;
  /** Standard error in the paper's Table 2, and the proposed method's value in its Table 3. */
  paperError: number;
  paperValue: number;
}

export const UNKNOWNS: readonly Unknown[] = [
  { field: 'omega_deg', symbol: 'ω', unit: '°', digits: 4, paperError: 0.0477, paperValue: 0.9137 },
  { field: 'phi_deg', symbol: 'φ', unit: '°', digits: 4, paperError: 0.0688, paperValue: 0.0187 },
  { field: 'kappa_deg', symbol: 'κ', unit: '°', digits: 4, paperError: 0.0202, paperValue: 0.3708 },
  { field: 'by_mm', symbol: 'by', unit: 'mm', digits: 4, paperError: 0.1373, paperValue: -2.2811 },
  { field: 'bz_mm', symbol: 'bz', unit: 'mm', digits: 4, paperError: 0.0746, paperValue: 0.0605 },
];

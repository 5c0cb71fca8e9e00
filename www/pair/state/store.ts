/** Holds the state of the pair. */
import { Holder } from '../../shared/state/store';
import type { Action } from './actions';
import { reduce } from './reducer';
import { INITIAL } from './state';
import type { State } from './state';

export class Store extends Holder<State, Action> {
  constructor() {
    super(INITIAL, reduce);
  }
}

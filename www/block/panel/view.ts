/** A view of the block on the stage: what the switch of views needs to know of it. */
import type { BlockStore } from '../engine/engine';
import type { ViewName } from '../state/state';
import type { Looking, Zoomable } from '../view/looking';

export interface StageView {
  name: ViewName;
  /** On its button. */
  title: string;
  /** Makes it, once it is shown for the first time. */
  mount: (store: BlockStore, looking: Looking) => MountedView;
}

export interface MountedView {
  /** What fills the stage. */
  element: HTMLElement;
  /** What stands over it while it is shown. */
  tools: readonly HTMLElement[];
  /** What it shows, in words. */
  legend?: HTMLElement;
  /** What the buttons that enlarge do. */
  zoomable: Zoomable;
  /** What its keys do. */
  keys: string;
}

/** The element that says what keys do. */
export const KEYS_ID = 'block-keys';

/** What the views ask of the finished block: answered by its worker, and kept until another block is shown. */
import type { Position } from '../../shared/state/pane';
import type { PointDetail } from '../../../pkg/wasm/tiepoint.js';
import type { ImagePoints, ViewObservations } from '../state/facts';
import type { ViewGround } from '../state/ground';
import type { BlockView } from '../state/view';
import type { BlockEngine, BlockStore } from './engine';

/** A line is asked for so many places at the same time: the pointer does not wait for places that it has left. */
const MOST_LINES = 16;

export class Facts {
  private of: BlockView | null = null;
  private readonly answers = new Map<string, unknown>();
  private readonly asked = new Set<string>();
  private readonly listeners: (() => void)[] = [];
  private waiting: ((goesOn: boolean) => void)[] = [];

  constructor(
    private readonly store: BlockStore,
    private readonly engine: BlockEngine,
  ) {}

  /** Calls back whenever an answer has come. */
  watch(arrived: () => void): void {
    this.listeners.push(arrived);
  }

  /** Whether answers are on their way. */
  get isAsked(): boolean {
    return this.asked.size > 0;
  }

  /** Until one of them has come, or another block has, which is asked anew: false where one will not come any more. */
  answered(): Promise<boolean> {
    return new Promise((resolve) => this.waiting.push(resolve));
  }

  /** The observations of an image; null while they are on their way. */
  points(image: number): ImagePoints | null {
    return this.get(`points ${String(image)}`, () => this.engine.imagePoints(image));
  }

  /** All observations; null while they are on their way. */
  observations(): ViewObservations | null {
    const images = this.store.state.shown?.view.images.length ?? 0;
    return this.get('observations', () => this.engine.observations(images));
  }

  /** Where the images lie on the ground; null before the block is oriented, and while it is on its way. */
  ground(): ViewGround | null {
    return (this.store.state.shown?.view.oriented ?? 0) === 0 ? null : this.get('ground', () => this.engine.ground());
  }

  point(index: number): PointDetail | null {
    return this.get(`point ${String(index)}`, () => this.engine.pointDetail(index));
  }

  /** Where the ground at a place of one image may lie in another: x, y in px. */
  line(from: number, [x, y]: Position, to: number): Float64Array | null {
    const name = `line ${[from, to, x, y].join(' ')}`;
    const lines = [...this.asked].filter((other) => other.startsWith('line'));
    if (!this.answers.has(name) && !this.asked.has(name) && lines.length >= MOST_LINES) return null;
    return this.get(name, () => this.engine.epipolarLine(from, x, y, to));
  }

  private get<T>(name: string, ask: () => Promise<T>): T | null {
    const { shown, running } = this.store.state;
    if (this.of !== (shown?.view ?? null)) this.forget(shown?.view ?? null);
    if (this.answers.has(name)) return this.answers.get(name) as T;
    // The worker that runs a block holds the former one no longer when it comes to the question.
    if (shown === null || shown.view.partial || running.kind === 'yes' || this.asked.has(name)) return null;
    const { of } = this;
    this.asked.add(name);
    ask().then(
      (answer) => {
        if (this.of !== of) return;
        this.asked.delete(name);
        this.keep(name, answer);
        for (const listener of this.listeners) listener();
        this.goOn(true);
      },
      () => {
        // The worker was ended, or holds no block: the next drawing asks again.
        if (this.of !== of) return;
        this.asked.delete(name);
        this.goOn(false);
      },
    );
    return null;
  }

  /** Of lines, which are many, the latest. */
  private keep(name: string, answer: unknown): void {
    this.answers.set(name, answer);
    const lines = [...this.answers.keys()].filter((other) => other.startsWith('line'));
    for (const old of lines.slice(0, Math.max(0, lines.length - 8 * MOST_LINES))) this.answers.delete(old);
  }

  private forget(of: BlockView | null): void {
    this.of = of;
    this.answers.clear();
    this.asked.clear();
    this.goOn(true);
  }

  private goOn(goesOn: boolean): void {
    const { waiting } = this;
    this.waiting = [];
    for (const resolve of waiting) resolve(goesOn);
  }
}

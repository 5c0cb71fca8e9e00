/** What the map and the matrix of a block have in common: shown whole until it is moved, pointed at, pressed. */
import { onRecolour, themeColours } from '../../shared/view/colours';
import type { Colours } from '../../shared/view/colours';
import { declare } from '../../shared/view/commands';
import type { Command } from '../../shared/view/commands';
import { listen } from '../../shared/view/gestures';
import { Layers } from '../../shared/view/layers';
import { panned, resized, zoomedAbout } from '../../shared/view/transform';
import type { Size, Transform } from '../../shared/view/transform';
import type { BlockStore } from '../engine/engine';
import type { Choice } from '../state/selection';
import type { BlockView } from '../state/view';
import { press } from './looking';
import type { Looking, Zoomable } from './looking';
import { say } from '../../shared/text/words';

/** What is drawn with Shift held down: from one place of the canvas to another, null where it was given up, by all places on the way. */
export interface Drawn {
  from: [number, number];
  to: [number, number] | null;
  path: readonly [number, number][];
}

/** What lists of keys call it. */
const WHERE: Readonly<Record<string, string>> = { map: say('map'), matrix: say('matrix'), plot: say('plots') };

export abstract class Chart implements Zoomable {
  protected readonly layers: Layers<string>;
  /** Where it was moved to, and how large the canvas was; null: all of it is shown. */
  private moved: { t: Transform; on: Size } | null = null;
  private of: BlockView | null = null;

  constructor(
    host: HTMLElement,
    name: string,
    protected readonly store: BlockStore,
    protected readonly looking: Looking,
  ) {
    this.layers = new Layers(host, [name], (_, context) => {
      const view = this.view();
      if (view !== null && view.images.length > 0) this.paint(context, themeColours(), view, this.current(view));
    });
    onRecolour(() => this.layers.redraw());
    const ofChoice = declare({ where: WHERE[name] ?? '', host, list: this.choiceKeys(), lacks: say('no-pair-is-chosen') });
    listen<BlockView>(host, {
      at: () => this.view(),
      focused: () => this.view(),
      pan: (view, dx, dy) => this.move(view, panned(this.current(view), dx, dy)),
      zoom: (view, factor, x, y) => this.zoom(view, factor, x, y),
      zoomMiddle: (factor) => this.zoomMiddle(factor),
      fit: () => this.fit(),
      pressed: (x, y) => press(store, looking, this.choiceAt(x, y)),
      encloses: (shift) => shift && this.enclosed !== null,
      enclosed: (view, from, to, ended, path) => this.enclosed?.(view, { from, to, path }, ended),
      pointed: (at, dragging) => {
        this.placed?.(at);
        if (!dragging) this.looking.point(at === null ? null : this.choiceAt(...at));
      },
      command: (key) => this.command(key) || ofChoice(key, false),
    });
    store.watch(['shown', 'selection'], ([shown]) => {
      if (shown?.view !== this.of && !isSameBlock(this.of, shown?.view ?? null)) this.moved = null;
      this.of = shown?.view ?? null;
      this.layers.redraw();
    });
  }

  /** The transform that shows all. */
  protected abstract whole(view: BlockView): Transform;
  /** The scales that are allowed, from the one that shows all. */
  protected abstract limits(whole: number): { least: number; most: number };
  protected abstract hit(view: BlockView, t: Transform, x: number, y: number): Choice | null;
  protected abstract paint(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, t: Transform): void;
  /** Runs the command of a key; false where it has none. */
  protected abstract command(key: string): boolean;

  /** Takes what is drawn with Shift; `ended`: it stands. Null: nothing can be drawn. */
  protected readonly enclosed: ((view: BlockView, drawn: Drawn, ended: boolean) => void) | null = null;
  /** Told where the pointer is; null where it has left. */
  protected readonly placed: ((at: [number, number] | null) => void) | null = null;

  /** Keeps it in sight. */
  protected held(_view: BlockView, t: Transform): Transform {
    return t;
  }

  fit(): void {
    this.moved = null;
    this.layers.redraw();
  }

  zoomMiddle(factor: number): void {
    const view = this.view();
    if (view !== null) this.zoom(view, factor, this.layers.width / 2, this.layers.height / 2);
  }

  protected view(): BlockView | null {
    return this.store.state.shown?.view ?? null;
  }

  protected current(view: BlockView): Transform {
    return this.moved === null ? this.whole(view) : this.held(view, resized(this.moved.t, this.moved.on, this.layers));
  }

  protected move(view: BlockView, t: Transform): void {
    const { width, height } = this.layers;
    this.moved = { t: this.held(view, t), on: { width, height } };
    this.layers.redraw();
  }

  private zoom(view: BlockView, factor: number, x: number, y: number): void {
    this.move(view, zoomedAbout(this.current(view), factor, x, y, this.limits(this.whole(view).scale)));
  }

  private choiceAt(x: number, y: number): Choice | null {
    const view = this.view();
    return view === null ? null : this.hit(view, this.current(view), x, y);
  }

  /** What keys do with what is chosen. */
  private choiceKeys(): Command[] {
    const pair = () => {
      const { chosen } = this.store.state.selection;
      return chosen?.kind === 'pair' ? chosen.images : null;
    };
    const open = () => {
      const images = pair();
      if (images !== null) this.looking.open(images);
    };
    return [
      { keys: ['Enter'], does: say('opens-the-chosen-pair'), can: () => pair() !== null, run: open },
      {
        keys: ['Escape'],
        does: say('chooses-nothing'),
        lacks: () => (this.store.state.selection.chosen === null ? say('nothing-is-chosen') : ''),
        run: () => this.looking.choose(null),
      },
    ];
  }
}

/** What the user looks at stays while more of the same comes in, and while the same images are adjusted anew. */
function isSameBlock(before: BlockView | null, after: BlockView | null): boolean {
  if (before === null || after === null || before.layout.kind !== after.layout.kind || before.partial !== after.partial) return false;
  return after.partial || before.images.length === after.images.length;
}

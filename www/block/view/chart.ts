/** What the picture and the matrix of a block have in common: shown whole until it is moved, pointed at, pressed. */
import { onRecolour, themeColours } from '../../shared/view/colours';
import type { Colours } from '../../shared/view/colours';
import { listen } from '../../shared/view/gestures';
import { Layers } from '../../shared/view/layers';
import { panned, zoomedAbout } from '../../shared/view/transform';
import type { Transform } from '../../shared/view/transform';
import type { BlockStore } from '../engine/engine';
import type { Choice } from '../state/state';
import type { BlockView } from '../state/view';
import { press } from './looking';
import type { Looking, Zoomable } from './looking';

export abstract class Chart implements Zoomable {
  protected readonly layers: Layers<string>;
  /** Null: all of it is shown. */
  private moved: Transform | null = null;
  private of: BlockView | null = null;
  /** What the pointer is over. */
  protected hovered: Choice | null = null;

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
    listen<BlockView>(host, {
      at: () => this.view(),
      focused: () => this.view(),
      pan: (view, dx, dy) => this.move(view, panned(this.current(view), dx, dy)),
      zoom: (view, factor, x, y) => this.zoom(view, factor, x, y),
      zoomMiddle: (factor) => this.zoomMiddle(factor),
      fit: () => this.fit(),
      pressed: (x, y) => press(store, looking, this.choiceAt(x, y)),
      pointed: (at, dragging) => {
        if (!dragging) this.hover(at === null ? null : this.choiceAt(...at));
      },
      command: (key) => this.command(key) || this.commandOfChoice(key),
    });
    store.watch(['shown', 'choice'], ([shown]) => {
      // What the user looks at stays while more of the same comes in.
      const same = shown?.view.partial === true && this.of?.partial === true && shown.view.layout.kind === this.of.layout.kind;
      if (shown?.view !== this.of && !same) this.moved = null;
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
    return this.moved ?? this.whole(view);
  }

  protected move(view: BlockView, t: Transform): void {
    this.moved = this.held(view, t);
    this.layers.redraw();
  }

  private zoom(view: BlockView, factor: number, x: number, y: number): void {
    this.move(view, zoomedAbout(this.current(view), factor, x, y, this.limits(this.whole(view).scale)));
  }

  private choiceAt(x: number, y: number): Choice | null {
    const view = this.view();
    return view === null ? null : this.hit(view, this.current(view), x, y);
  }

  private hover(choice: Choice | null): void {
    this.hovered = choice;
    this.looking.point(choice);
    this.layers.redraw();
  }

  private commandOfChoice(key: string): boolean {
    const { choice } = this.store.state;
    if (key === 'Enter' && choice?.kind === 'pair') this.looking.open(choice.images);
    else if (key === 'Escape') this.looking.choose(null);
    else return false;
    return true;
  }
}

/** The map of a block: its images from above with what joins them, its tie points, and what was measured on the ground; pan, zoom, point, press and brush. */
import type { Colours } from '../../../shared/view/colours';
import { declare } from '../../../shared/view/commands';
import { toPosition } from '../../../shared/view/transform';
import type { Transform } from '../../../shared/view/transform';
import type { BlockStore } from '../../engine/engine';
import type { PlacingEngine } from '../../engine/placing';
import type { Facts } from '../../engine/facts';
import { keptBy } from '../../state/columns';
import type { Tabled } from '../../state/columns';
import { medianGsd, systemOf } from '../../state/ground';
import { resultSystem } from '../../state/result-system';
import type { System, ViewGround } from '../../state/ground';
import type { GivenOrthophoto } from '../../state/placing';
import { laidUnder } from '../../state/laid';
import type { Laid } from '../../state/laid';
import { choiceOfPoints, imagesOf, pointsOf } from '../../state/selection';
import type { Choice } from '../../state/selection';
import type { BlockView } from '../../state/view';
import { Chart } from '../chart';
import type { Drawn } from '../chart';
import type { Looking } from '../looking';
import { OrthophotoTiles } from '../orthophoto/tiles';
import { colouredPoints } from './colouring';
import { paintGrid, paintNorth, paintScale, haloed } from './frame';
import { factorOf, longestText, offsetsOf, paintFootprints, paintGnss, paintOnGround, paintSurveyed } from './ground';
import type { Offsets } from './ground';
import { isMarked, MANY_LINES, NAME_BELOW, NAME_HEIGHT, paintImages, paintLines, paintMarkedLines, paintNames, soundness } from './images';
import type { Shown } from './images';
import { FIRST_LOOK } from './look';
import type { MapLook } from './look';
import { fitPlan, imageAt, lineAt, linesOf, nearestImages, placeOf, thumbWidth } from './plan';
import { pointAt, PointBitmap, pointPlace, pointsWithin } from './points';
import { Still } from './still';
import { MOST_THUMBS, Thumbs } from './thumbs';
import { asSentence } from '../../../shared/text/direction';
import { say } from '../../../shared/text/words';

export class BlockMap extends Chart {
  private readonly thumbs = new Thumbs(() => this.layers.redraw());
  private readonly bitmap = new PointBitmap();
  private readonly lines = new Still(() => this.layers.redraw());
  private look: MapLook = FIRST_LOOK;
  /** The outline that is being drawn. */
  private outline: readonly [number, number][] = [];
  private readonly listeners: (() => void)[] = [];
  /** Where the pointer is, in the system of the block. */
  private pointer: [number, number] | null = null;
  private readonly tiles: OrthophotoTiles;
  /** Whether the orthophoto lay under the map when it was looked at last. */
  private hadOrthophoto = false;

  constructor(
    host: HTMLElement,
    store: BlockStore,
    looking: Looking,
    private readonly facts: Facts,
    placing: PlacingEngine,
  ) {
    super(host, 'map', store, looking);
    this.keys = declare({
      where: say('map'),
      host,
      lacks: say('no-pair-is-chosen'),
      list: [
        { keys: ['n'], does: say('chooses-the-next-image'), run: () => this.step(1) },
        { keys: ['p'], does: say('chooses-the-previous-image'), run: () => this.step(-1) },
        { keys: ['c'], does: say('chooses-the-next-pair-of'), run: () => this.stepPair() },
      ],
    });
    this.tiles = new OrthophotoTiles(
      (level, column, row) => placing.tile(level, column, row),
      () => this.layers.redraw(),
    );
    facts.watch(() => this.changed());
    store.watch(['shown', 'selection'], () => this.tell());
    store.watch(
      (s) => [s.placing.orthophoto, s.placing.placed] as const,
      () => this.changed(),
    );
  }

  private readonly keys: (key: string, shift: boolean) => boolean;

  /** Calls back now and whenever other things are shown, or the pointer is elsewhere. */
  watch(changed: () => void): void {
    this.listeners.push(changed);
    changed();
  }

  get shows(): MapLook {
    return this.look;
  }

  show(look: Partial<MapLook>): void {
    this.look = { ...this.look, ...look };
    this.changed();
  }

  /** Where the pointer is; null where it is not over the map, or places mean nothing. */
  get place(): readonly [number, number] | null {
    return this.view()?.layout.kind === 'connections' ? null : this.pointer;
  }

  ground(): ViewGround | null {
    return this.facts.ground();
  }

  get orthophoto(): GivenOrthophoto | null {
    return this.store.state.placing.orthophoto;
  }

  /** How the orthophoto lies under the map; null where there is none, or nothing says how. */
  laid(): Laid | null {
    const { placing, files, shown } = this.store.state;
    const view = shown?.view ?? null;
    if (view === null || placing.orthophoto === null) return null;
    const ground = this.ground();
    return laidUnder(placing.orthophoto, placing.placed, files, shown, ground, systemOf(view, ground));
  }

  private changed(): void {
    const has = this.laid() !== null;
    // Photos on the ground would hide it.
    if (has && !this.hadOrthophoto) this.look = { ...this.look, photos: false, footprints: true };
    this.hadOrthophoto = has;
    this.layers.redraw();
    this.tell();
  }

  private tell(): void {
    for (const listener of this.listeners) listener();
  }

  protected override readonly placed = (at: [number, number] | null): void => {
    const view = this.view();
    const place = at === null || view === null ? null : toPosition(this.current(view), ...at);
    this.pointer = place === null ? null : [place[0], -place[1]];
    this.tell();
  };

  /** The tie points in what is drawn are chosen together. */
  protected override readonly enclosed = (view: BlockView, drawn: Drawn, ended: boolean): void => {
    const outline = drawn.to === null ? [] : this.look.lasso ? [...drawn.path] : cornersOf(drawn.from, drawn.to);
    this.outline = ended ? [] : outline;
    if (ended && this.look.colouring !== 'none')
      this.looking.choose(choiceOfPoints(pointsWithin(view.points, this.keeps(view, 'points'), this.current(view), outline)));
    this.layers.redraw();
  };

  protected override whole(view: BlockView): Transform {
    const footprints = view.layout.kind === 'oriented' ? (this.ground()?.footprints ?? null) : null;
    return fitPlan(view, footprints, this.layers.width, this.layers.height);
  }

  protected override limits(whole: number): { least: number; most: number } {
    return { least: 0.2 * whole, most: 200 * whole };
  }

  private keeps(view: BlockView, subject: Tabled): (row: number) => boolean {
    return keptBy(subject, view, this.store.state.selection);
  }

  protected override hit(view: BlockView, t: Transform, x: number, y: number): Choice | null {
    const { colouring, connections } = this.look;
    // Over a photo a point is pointed at, beside it the photo.
    const point = colouring === 'none' ? -1 : pointAt(view.points, this.keeps(view, 'points'), t, x, y);
    const image = imageAt(view, t, this.keeps(view, 'images'), this.thumbSide(view, t, this.ground()), x, y);
    if (image >= 0 && (point < 0 || distance(placeOf(view, t, image), x, y) <= distance(pointPlace(view.points, t, point), x, y)))
      return { kind: 'image', image };
    if (point >= 0) return { kind: 'point', point };
    const images = connections ? lineAt(view, t, this.keeps(view, 'pairs'), x, y) : null;
    return images === null ? null : { kind: 'pair', images };
  }

  protected override command(key: string): boolean {
    return this.keys(key, false);
  }

  /** Chooses the next image that is kept. */
  private step(by: number): void {
    const view = this.view();
    if (view === null) return;
    const kept = view.images.map((_, image) => image).filter(this.keeps(view, 'images'));
    const now = kept.indexOf(imagesOf(this.store.state.selection.chosen)[0] ?? -1);
    const image = kept[now < 0 ? (by > 0 ? 0 : kept.length - 1) : (now + by + kept.length) % kept.length];
    if (image !== undefined) this.looking.choose({ kind: 'image', image });
  }

  /** Chooses the next connection of the image that is chosen, or of the first of the pair. */
  private stepPair(): void {
    const view = this.view();
    const { chosen } = this.store.state.selection;
    const [image] = imagesOf(chosen);
    if (view === null || image === undefined) return;
    const keeps = this.keeps(view, 'pairs');
    const own = view.connections
      .filter((_, pair) => keeps(pair))
      .map(({ images }) => images)
      .filter((images) => images.includes(image))
      .map(([a, b]): [number, number] => (a === image ? [a, b] : [b, a]));
    const at = chosen?.kind === 'pair' ? own.findIndex(([, b]) => b === chosen.images[1]) : -1;
    const next = own[(at + 1) % Math.max(1, own.length)];
    if (next !== undefined) this.looking.choose({ kind: 'pair', images: next });
  }

  protected override paint(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, t: Transform): void {
    const { width, height } = this.layers;
    const { chosen, pointed } = this.store.state.selection;
    const { look } = this;
    const ground = this.ground();
    const system = systemOf(view, ground);
    const hasPlaces = view.layout.kind !== 'connections';
    const shown: Shown = {
      marked: [chosen, pointed].filter((choice) => choice !== null).filter((choice) => imagesOf(choice).length > 0),
      keepsImage: this.keeps(view, 'images'),
      keepsPair: this.keeps(view, 'pairs'),
    };
    const outlined = (image: number) => look.footprints && shown.keepsImage(image);
    const { orthophoto } = this.store.state.placing;
    const laid = look.orthophoto && orthophoto !== null ? this.laid() : null;
    if (laid !== null && orthophoto !== null) this.tiles.paint(context, orthophoto, laid.sheet, t, [width, height, this.layers.ratio]);
    if (ground !== null) this.paintPhotos(context, colours, view, t, ground, shown);
    if (hasPlaces) paintGrid(context, colours, t, width, height, resultSystem(view).toBlock);
    if (ground !== null && hasPlaces) paintFootprints(context, colours, ground, t, outlined, (image) => isMarked(shown, image));
    if (look.connections) this.paintConnections(context, colours, view, t, shown);
    const below = ground === null ? this.paintPhotos(context, colours, view, t, ground, shown) : NAME_BELOW;
    this.paintPoints(context, colours, view, t, chosen, pointed);
    if (below === NAME_BELOW) paintImages(context, colours, view, t, shown);
    paintNames(context, colours, view, t, shown, below);
    if (!hasPlaces) return;
    const offsets = offsetsOf(view, ground, shown.keepsImage, this.keeps(view, 'surveyed'));
    const factor = factorOf(Math.max(offsets.longest.gnss.plan, offsets.longest.surveyed.plan), t);
    if (look.offsets) paintGnss(context, offsets, t, factor);
    paintSurveyed(context, colours, offsets, t, factor, look.offsets, [width, height]);
    paintScale(context, colours, t, height, system, medianGsd(view, ground));
    if (system !== 'own') paintNorth(context, colours, width, system);
    if (look.offsets) this.paintOffsetLegend(context, colours, offsets, factor, system);
    this.paintOutline(context, colours);
  }

  /** Those of what is marked stand out of the others. */
  private paintConnections(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, t: Transform, shown: Shown): void {
    const { keepsPair, marked } = shown;
    const { width, height, ratio } = this.layers;
    context.globalAlpha = marked.length > 0 ? 0.4 : 1;
    const draw = (on: CanvasRenderingContext2D, plan: Transform) => paintLines(on, colours, view, plan, keepsPair);
    if (linesOf(view).length < MANY_LINES) draw(context, t);
    else this.lines.paint(context, t, [width, height, ratio], [view, keepsPair, colours], draw);
    context.globalAlpha = 1;
    paintMarkedLines(context, colours, view, t, shown);
  }

  /** What the lines beside images and surveyed points are, over the scale bar. */
  private paintOffsetLegend(context: CanvasRenderingContext2D, colours: Colours, { longest }: Offsets, factor: number, system: System): void {
    const parts = [
      longest.gnss.plan > 0 ? say('gnss-minus-adjusted-up-to', { gnss: longestText(longest.gnss, system) }) : '',
      longest.surveyed.plan > 0 ? say('adjusted-minus-surveyed-up-to', { surveyed: longestText(longest.surveyed, system) }) : '',
    ].filter((part) => part !== '');
    if (parts.length === 0) return;
    context.font = '11px system-ui, sans-serif';
    context.textAlign = 'start';
    const [first = '', ...others] = [...parts, say('drawn-longer', { factor })];
    const clauses = [first.charAt(0).toUpperCase() + first.slice(1), ...others];
    const whole = clauses.join(say('between-clauses'));
    const { width, height } = this.layers;
    // On a phone it stands in lines: a figure that is cut reads as another one.
    const lines = context.measureText(whole).width <= width - 24 ? [whole] : clauses;
    for (const [i, line] of lines.reverse().entries()) haloed(context, colours, asSentence(line), 12, height - 38 - 14 * i);
  }

  private paintOutline(context: CanvasRenderingContext2D, colours: Colours): void {
    if (this.outline.length === 0) return;
    context.strokeStyle = colours.accent;
    context.lineWidth = 1.5;
    context.setLineDash([5, 3]);
    context.beginPath();
    for (const place of this.outline) context.lineTo(...place);
    context.closePath();
    context.stroke();
    context.setLineDash([]);
  }

  private paintPoints(context: CanvasRenderingContext2D, colours: Colours, view: BlockView, t: Transform, chosen: Choice | null, pointed: Choice | null): void {
    const { points } = view;
    const coloured = colouredPoints(points, this.look.colouring);
    if (coloured === null || view.layout.kind !== 'oriented') return;
    const { width, height, ratio } = this.layers;
    const keeps = this.keeps(view, 'points');
    this.bitmap.paint(context, t, width, height, ratio, {
      points,
      coloured,
      keeps,
      chosen: pointsOf(chosen),
      pointed: pointsOf(pointed),
      mark: colours.problem,
      edge: colours.surface,
    });
  }

  /** Paints the photos once a run has ended: each on its ground where that is known, else about its place, where they have room. Gives how far below that its name stands. */
  private paintPhotos(
    context: CanvasRenderingContext2D,
    colours: Colours,
    view: BlockView,
    t: Transform,
    ground: ViewGround | null,
    { keepsImage, ...marks }: Shown,
  ): number {
    const { shown, files, running } = this.store.state;
    const width = this.thumbSide(view, t, ground);
    if (!this.look.photos || (ground === null && width === 0) || shown === null || running.kind === 'yes') return NAME_BELOW;
    const ofName = new Map([...files, ...shown.files].map((file) => [file.name, file]));
    const fileOf = (image: number) => ofName.get(view.images[image]?.name ?? '');
    const middle = [this.layers.width / 2, this.layers.height / 2] as const;
    const near = nearestImages(view, t, (image) => keepsImage(image) && fileOf(image) !== undefined, middle, MOST_THUMBS);
    const thumbs = new Map(near.flatMap((image) => fileOf(image) ?? []).map((file) => [file.id, this.thumbs.get(file)]));
    this.thumbs.shows(new Set(thumbs.keys()));
    const isSound = soundness(view);
    let below = NAME_BELOW;
    // In their order, whichever are near.
    for (const i of near.sort((a, b) => a - b)) {
      const thumb = thumbs.get(fileOf(i)?.id ?? -1) ?? null;
      if (thumb === null) continue;
      if (ground !== null) {
        paintOnGround(context, thumb, ground, t, i);
        continue;
      }
      const height = (width * thumb.height) / thumb.width;
      const [x, y] = placeOf(view, t, i);
      context.drawImage(thumb, x - width / 2, y - height / 2, width, height);
      const on = isMarked({ keepsImage, ...marks }, i);
      context.lineWidth = on ? 3 : 1.5;
      context.strokeStyle = on ? colours.accent : isSound(i) ? colours.surface : colours.problem;
      context.strokeRect(x - width / 2, y - height / 2, width, height);
      below = Math.max(below, height / 2 + NAME_HEIGHT);
    }
    return below;
  }

  /** How wide photos are drawn about their places; 0 where they lie on the ground, or have no room. */
  private thumbSide(view: BlockView, t: Transform, ground: ViewGround | null): number {
    return ground === null && this.look.photos ? thumbWidth(view, t) : 0;
  }
}

/** Of a rectangle between two places. */
function cornersOf([x0, y0]: [number, number], [x1, y1]: [number, number]): [number, number][] {
  return [
    [x0, y0],
    [x1, y0],
    [x1, y1],
    [x0, y1],
  ];
}

function distance([px, py]: readonly [number, number], x: number, y: number): number {
  return Math.hypot(px - x, py - y);
}

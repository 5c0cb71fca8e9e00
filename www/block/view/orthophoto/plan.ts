/** The orthophoto from above, with what is placed on it: footprints, projection centres, and the links of the chosen image. */
import { remember } from '../../../shared/state/remember';
import { ACCEPTED, REJECTED } from '../../../shared/view/palette';
import type { Colours } from '../../../shared/view/colours';
import { toCanvas, toPosition } from '../../../shared/view/transform';
import type { Transform } from '../../../shared/view/transform';
import type { BlockStore } from '../../engine/engine';
import type { LinkHands } from '../../engine/link-hands';
import type { PlacingEngine } from '../../engine/placing';
import { shownLinks } from '../../state/steps';
import type { LinkedPlacement } from '../../state/links';
import { placedFiles } from '../../state/placed';
import type { PlacedFile } from '../../state/placed';
import type { GivenOrthophoto, Looked } from '../../state/placing';
import { affineOf, mapped, SAME } from '../../state/under';
import { haloed, paintGrid, paintNorth, paintScale } from '../map/frame';
import { drawLinks, drawRing, linksOnGround } from './links';
import type { DrawnLinks } from './links';
import { ImageOver } from './over';
import { LinkPicture } from './picture';
import type { Box } from './picture';
import { OrthophotoTiles } from './tiles';
import { say } from '../../../shared/text/words';

/** How near a projection centre is pointed at, CSS px. */
const REACH = 12;
/** More images than these have their names only where they are chosen. */
const MOST_NAMES = 60;

/** Coordinates of a map are those of its system. */
const SYSTEM = 'surveyed';

/** Of what is placed, with doubt, and not: seen on any picture, and told apart with any colour vision. */
const VERDICTS = { placed: ACCEPTED.colour, weak: '#ffb000', not_placed: REJECTED.colour } as const;

export class OrthophotoPlan extends LinkPicture {
  private readonly tiles: OrthophotoTiles;
  private readonly over: ImageOver;
  private lays = false;
  private readonly drawn = remember(linksOnGround);

  constructor(host: HTMLElement, store: BlockStore, hands: LinkHands, keys: (key: string, shift: boolean) => boolean, engine: PlacingEngine) {
    super(host, store, hands, keys);
    this.tiles = new OrthophotoTiles(
      (level, column, row) => engine.tile(level, column, row),
      () => this.layers.redraw('picture'),
    );
    this.over = new ImageOver(
      ({ file }, placement, side) => engine.laid(file, placement, side),
      () => this.layers.redraw('picture'),
    );
    store.watch(['placing', 'files', 'options'], () => this.layers.redraw());
  }

  /** Whether the chosen image lies over the orthophoto. */
  get isLaid(): boolean {
    return this.lays;
  }

  set isLaid(lays: boolean) {
    this.lays = lays;
    this.layers.redraw('picture');
  }

  protected override whole(): Box | null {
    const { orthophoto } = this.store.state.placing;
    return orthophoto === null ? null : boxOf(cornersOf(orthophoto));
  }

  /** Shows the ground of an image, with all of its footprint. */
  showImage({ footprint, pose }: LinkedPlacement): void {
    this.show(boxOf([...footprint, [pose.position[0], pose.position[1]]]));
  }

  protected override mostScale(fits: number): number {
    // A pixel of the orthophoto is at most some 40 px large.
    const { orthophoto } = this.store.state.placing;
    return Math.max(4 * fits, 40 / (orthophoto?.info.gsd ?? 1));
  }

  protected override links(): DrawnLinks | null {
    const chosen = this.chosen();
    const links = chosen === null ? null : shownLinks(chosen);
    return links === null ? null : this.drawn(links);
  }

  protected override end(): readonly [number, number] | null {
    const place = this.store.state.placing.draft?.place ?? null;
    return place === null ? null : [place[0], -place[1]];
  }

  protected override measured([east, south]: [number, number]): void {
    void this.hands.place('place', [east, -south]).then((at) => this.image?.expect(at));
  }

  /** The image beside it. */
  image: LinkPicture | null = null;

  protected override pressed(x: number, y: number): void {
    const box = this.whole();
    if (!this.store.state.placing.picks || box === null) {
      super.pressed(x, y);
      return;
    }
    const [east, south] = toPosition(this.current(box), x, y);
    const { gsd } = this.store.state.placing.orthophoto?.info ?? { gsd: 1 };
    // No finer than a pixel.
    const round = (value: number) => Number(value.toFixed(Math.max(0, Math.ceil(-Math.log10(gsd)))));
    this.store.dispatch({ type: 'placingOptions', options: { near_x: round(east), near_y: round(-south) } });
  }

  /** The image whose centre is near, else the one on whose ground the place lies, the nearest centre first. */
  protected override other(x: number, y: number): Looked | null {
    const box = this.whole();
    if (box === null) return null;
    const t = this.current(box);
    const [east, south] = toPosition(t, x, y);
    const near = this.placements()
      .map(({ file, placement }) => {
        const [cx, cy] = toCanvas(t, placement.pose.position[0], -placement.pose.position[1]);
        const distance = Math.hypot(cx - x, cy - y);
        return { id: file.id, distance, isOn: distance < REACH || isInside(placement.footprint, east, -south) };
      })
      .filter(({ isOn }) => isOn)
      .sort((a, b) => a.distance - b.distance);
    const [first] = near;
    return first === undefined ? null : { image: first.id, link: null };
  }

  private placements(): (PlacedFile & { placement: LinkedPlacement })[] {
    return placedFiles(this.store.state).flatMap((placed) => {
      const placement = placed.result?.placement ?? null;
      return placement === null ? [] : [{ ...placed, placement }];
    });
  }

  protected override paintPicture(context: CanvasRenderingContext2D, t: Transform): void {
    const { orthophoto } = this.store.state.placing;
    const { width, height, ratio } = this.layers;
    if (orthophoto === null) return;
    this.tiles.paint(context, orthophoto, SAME, t, [width, height, ratio]);
    if (this.lays) this.over.paint(context, this.chosen(), t);
  }

  protected override paintMarks(context: CanvasRenderingContext2D, colours: Colours, t: Transform): void {
    const { width, height } = this.layers;
    const { chosen, pointed } = this.store.state.placing;
    paintGrid(context, colours, t, width, height);
    this.paintNear(context, colours, t);
    const all = this.placements();
    for (const placed of all) paintFootprint(context, t, placed, placed.file.id === chosen.image, placed.file.id === pointed.image);
    const links = this.links();
    if (links !== null) {
      drawLinks(context, links, t, { left: 0, top: 0, width, height }, this.store.state.placing.uses);
      if (pointed.image === chosen.image && pointed.link !== null) drawRing(context, links, pointed.link, t, false);
      if (chosen.link !== null) drawRing(context, links, chosen.link, t, true);
    }
    this.paintEnd(context, t);
    for (const placed of all) paintCentre(context, colours, t, placed, placed.file.id === chosen.image, all.length <= MOST_NAMES);
    paintScale(context, colours, t, height, SYSTEM);
    paintNorth(context, colours, width, SYSTEM);
  }

  /** Where images are sought, if that is said. */
  private paintNear(context: CanvasRenderingContext2D, colours: Colours, t: Transform): void {
    const { options } = this.store.state.placing;
    if (options?.near_x == null || options.near_y == null) return;
    const [x, y] = toCanvas(t, options.near_x, -options.near_y);
    context.save();
    context.strokeStyle = colours.accent;
    context.lineWidth = 2;
    context.setLineDash([6, 4]);
    context.beginPath();
    context.arc(x, y, Math.max(1, options.within_m * t.scale), 0, 2 * Math.PI);
    context.stroke();
    context.setLineDash([]);
    context.beginPath();
    for (const [dx, dy] of [
      [1, 0],
      [0, 1],
    ] as const) {
      context.moveTo(x - 7 * dx, y - 7 * dy);
      context.lineTo(x + 7 * dx, y + 7 * dy);
    }
    context.stroke();
    context.font = '11px system-ui, sans-serif';
    context.textAlign = 'start';
    haloed(context, colours, say('sought-from-here'), x + 9, y - 6);
    context.restore();
  }
}

function cornersOf({ info: { width, height, georeference } }: GivenOrthophoto): [number, number][] {
  const toGround = affineOf(georeference);
  return [
    [0, 0],
    [width, 0],
    [width, height],
    [0, height],
  ].map(([x = 0, y = 0]) => mapped(toGround, x, y));
}

/** Of places of the ground, as positions whose Y goes down. */
function boxOf(places: readonly (readonly [number, number])[]): Box {
  const [xs, ys] = [places.map(([x]) => x), places.map(([, y]) => -y)];
  return [Math.min(...xs), Math.min(...ys), Math.max(...xs), Math.max(...ys)];
}

/** Whether an outline goes about a place. */
function isInside(outline: readonly (readonly [number, number])[], x: number, y: number): boolean {
  let inside = false;
  outline.forEach(([ax, ay], i) => {
    const [bx, by] = outline[(i + 1) % outline.length] ?? [ax, ay];
    if (ay > y !== by > y && x < ax + ((bx - ax) * (y - ay)) / (by - ay)) inside = !inside;
  });
  return inside;
}

type Shown = PlacedFile & { placement: LinkedPlacement };

function colourOf({ result }: PlacedFile): string {
  return VERDICTS[result?.verdict.kind ?? 'not_placed'];
}

function paintFootprint(context: CanvasRenderingContext2D, t: Transform, shown: Shown, chosen: boolean, pointed: boolean): void {
  context.save();
  context.beginPath();
  for (const [x, y] of shown.placement.footprint) context.lineTo(...toCanvas(t, x, -y));
  context.closePath();
  // A dark line under it is seen on any ground.
  context.strokeStyle = 'rgb(0 0 0 / 0.55)';
  context.lineWidth = chosen ? 5 : 3;
  context.stroke();
  context.strokeStyle = colourOf(shown);
  context.lineWidth = chosen ? 2.5 : pointed ? 2 : 1.2;
  if (shown.isStale) context.setLineDash([6, 4]);
  context.stroke();
  // What is chosen shows its links.
  if (pointed && !chosen) {
    context.fillStyle = colourOf(shown);
    context.globalAlpha = 0.1;
    context.fill();
  }
  context.restore();
}

function paintCentre(context: CanvasRenderingContext2D, colours: Colours, t: Transform, shown: Shown, chosen: boolean, hasName: boolean): void {
  const [x, y] = toCanvas(t, shown.placement.pose.position[0], -shown.placement.pose.position[1]);
  context.save();
  context.beginPath();
  context.arc(x, y, chosen ? 7 : 5, 0, 2 * Math.PI);
  context.fillStyle = colourOf(shown);
  context.fill();
  context.lineWidth = 2;
  context.strokeStyle = colours.surface;
  context.stroke();
  if (hasName || chosen) {
    context.font = chosen ? '600 12px system-ui, sans-serif' : '11px system-ui, sans-serif';
    context.textAlign = 'center';
    haloed(context, colours, shown.file.name, x, y + 20);
  }
  context.restore();
}

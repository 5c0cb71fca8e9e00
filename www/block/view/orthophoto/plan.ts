/** The orthophoto from above, with what is placed on it: footprints, projection centres, and the places of the block or the links of the chosen image. */
import { remember } from '../../../shared/state/remember';
import { ACCEPTED, CANDIDATE, MEASURED, REJECTED, SELECTED } from '../../../shared/view/palette';
import type { Colours } from '../../../shared/view/colours';
import { toCanvas, toPosition } from '../../../shared/view/transform';
import type { Rect, Transform } from '../../../shared/view/transform';
import type { BlockStore } from '../../engine/engine';
import type { Facts } from '../../engine/facts';
import type { LinkHands } from '../../engine/link-hands';
import type { PlaceHands } from '../../engine/place-hands';
import type { PlacingEngine } from '../../engine/placing';
import { shownLinks } from '../../state/steps';
import { keptBy } from '../../state/columns';
import type { LinkedPlacement } from '../../state/links';
import { takesPlaces } from '../../state/places';
import { blockOnOrthophoto, toSystemOf } from '../../state/showing';
import { unitOfOrthophoto } from '../../state/orthophoto-unit';
import { placedFiles } from '../../state/placed';
import type { GivenOrthophoto, Looked } from '../../state/placing';
import { liesElsewhere } from '../../state/purpose';
import type { Choice } from '../../state/selection';
import { throughout } from '../../state/cells';
import { affineOf, SAME } from '../../state/under';
import { mapped } from '../../../shared/state/plane-map';
import type { Looking } from '../looking';
import { haloed, paintGrid, paintNorth, paintScale } from '../map/frame';
import { choiceAt, inSystem, onOrthophoto, paintBlock, placeOfChoice, stepped } from './block';
import type { OnOrthophoto } from './block';
import { footprintAt, paintCentres, paintFootprint } from './footprints';
import type { Footprint } from './footprints';
import { drawCross, drawLinks, drawRing, linksOnGround } from './links';
import type { DrawnLinks } from './links';
import { ImageOver } from './over';
import { LinkPicture } from './picture';
import type { Box } from './picture';
import { OrthophotoTiles } from './tiles';
import { say } from '../../../shared/text/words';

/** Coordinates of a map are those of its system. */
const SYSTEM = 'surveyed';

/** Of what is placed, with doubt, and not: seen on any picture, and told apart with any colour vision. */
const VERDICTS = { placed: ACCEPTED.colour, weak: '#ffb000', not_placed: REJECTED.colour } as const;

export class OrthophotoPlan extends LinkPicture {
  private readonly tiles: OrthophotoTiles;
  private readonly over: ImageOver;
  private lays = false;
  /** What was chosen last. */
  private followed: Choice | null = null;
  private readonly drawn = remember(linksOnGround);

  constructor(
    host: HTMLElement,
    store: BlockStore,
    hands: LinkHands,
    private readonly places: PlaceHands,
    keys: (key: string, shift: boolean) => boolean,
    engine: PlacingEngine,
    private readonly looking: Looking,
    private readonly facts: Facts,
  ) {
    super(host, store, hands, keys);
    this.tiles = new OrthophotoTiles(
      (level, column, row) => engine.tile(level, column, row),
      () => this.layers.redraw('picture'),
    );
    this.over = new ImageOver(
      ({ file }, placement, side) => engine.laid(file, placement, side),
      () => this.layers.redraw('picture'),
    );
    store.watch(['placing', 'files', 'options', 'shown', 'history'], () => this.layers.redraw());
    store.watch(['selection'], ([{ chosen }]) => this.follow(chosen));
    facts.watch(() => this.layers.redraw('marks'));
  }

  /** What of the block is drawn, where it lies on the orthophoto. */
  block(): OnOrthophoto | null {
    const { state } = this.store;
    const shown = blockOnOrthophoto(state);
    const { orthophoto } = state.placing;
    if (shown === null || orthophoto === null) return null;
    const drawn = inSystem(shown.view, this.facts.ground(), toSystemOf(orthophoto, shown.view) ?? SAME);
    const keeps = (subject: 'images' | 'surveyed') => keptBy(subject, shown.view, state.selection);
    return onOrthophoto(drawn.view, drawn.ground, liesElsewhere(state), keeps('images'), keeps('surveyed'));
  }

  /** What is chosen of the block elsewhere is brought into sight. */
  private follow(chosen: Choice | null): void {
    this.layers.redraw('marks');
    const block = this.block();
    const place = block === null || chosen === this.followed ? null : placeOfChoice(block, chosen);
    this.followed = chosen;
    if (place !== null) this.bring([place[0], -place[1]]);
  }

  /** Goes to the next image or place of the block, or the one before. */
  step(of: 'image' | 'place', by: 1 | -1): void {
    const block = this.block();
    if (block !== null) this.looking.choose(stepped(block, this.store.state.placing.uses, of, this.store.state.selection.chosen, by));
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

  /** Brings a place X, Y of the orthophoto into sight, where an end of a link is expected. */
  expectPlace(place: readonly [number, number] | null): void {
    this.expect(place === null ? null : [place[0], -place[1]]);
  }

  /** Takes the place in the middle, under the cross. */
  takeMiddle(): void {
    this.take(this.layers.width / 2, this.layers.height / 2);
  }

  /** Adds the place at a position of the canvas to the block. */
  private take(x: number, y: number): void {
    const box = this.whole();
    if (box === null) return;
    const [east, south] = toPosition(this.current(box), x, y);
    void this.places.take([east, -south]);
  }

  protected override pressed(x: number, y: number): void {
    const box = this.whole();
    if (this.store.state.placing.adds) {
      this.take(x, y);
      return;
    }
    if (!this.store.state.placing.picks || box === null) {
      const block = this.block();
      if (block === null || box === null) super.pressed(x, y);
      else {
        // It is in sight already.
        this.followed = this.choiceAt(block, box, x, y);
        this.looking.choose(this.followed);
      }
      return;
    }
    const [east, south] = toPosition(this.current(box), x, y);
    const { gsd } = this.store.state.placing.orthophoto?.info ?? { gsd: 1 };
    // No finer than a pixel.
    const round = (value: number) => Number(value.toFixed(Math.max(0, Math.ceil(-Math.log10(gsd)))));
    this.store.dispatch({ type: 'placingOptions', options: { near_x: round(east), near_y: round(-south) } });
  }

  protected override point(at: [number, number] | null): void {
    const [block, box] = [this.block(), this.whole()];
    if (block === null || box === null) super.point(at);
    else this.looking.point(at === null ? null : this.choiceAt(block, box, ...at));
  }

  private choiceAt(block: OnOrthophoto, box: Box, x: number, y: number): Choice | null {
    return choiceAt(block, this.store.state.placing.uses, this.current(box), x, y);
  }

  protected override other(x: number, y: number): Looked | null {
    const box = this.whole();
    const found = box === null ? null : footprintAt(this.footprints(), this.current(box), x, y);
    return found === null ? null : { image: found.of.file, link: null };
  }

  /** Of the images that were placed by themselves. */
  private footprints(): (Footprint & { file: number })[] {
    return placedFiles(this.store.state).flatMap(({ file, result, isStale }) => {
      const placement = result?.placement ?? null;
      if (result === null || placement === null) return [];
      const [x, y] = placement.pose.position;
      return [{ file: file.id, name: file.name, isStale, colour: VERDICTS[result.verdict.kind], centre: [x, y], outline: placement.footprint }];
    });
  }

  protected override paintPicture(context: CanvasRenderingContext2D, t: Transform): void {
    const { orthophoto } = this.store.state.placing;
    const { width, height, ratio } = this.layers;
    if (orthophoto === null) return;
    this.tiles.paint(context, orthophoto, throughout(affineOf(orthophoto.info.georeference)), t, [width, height, ratio]);
    if (this.lays) this.over.paint(context, this.chosen(), t);
  }

  protected override paintMarks(context: CanvasRenderingContext2D, colours: Colours, t: Transform): void {
    const { width, height } = this.layers;
    const clip = { left: 0, top: 0, width, height };
    paintGrid(context, colours, t, width, height);
    this.paintNear(context, colours, t);
    const block = this.block();
    if (block !== null) paintBlock(context, colours, t, clip, block, this.store.state.placing.uses, this.store.state.selection);
    else this.paintPlaced(context, colours, t, clip);
    this.paintWaiting(context, colours, t);
    if (this.store.state.placing.adds) drawCross(context, [width / 2, height / 2], MEASURED.colour);
    paintScale(context, colours, t, height, SYSTEM, null, unitOfOrthophoto(this.store.state.placing.orthophoto));
    paintNorth(context, colours, width, SYSTEM);
  }

  /** Images that were placed by themselves, and the links of the chosen one. */
  private paintPlaced(context: CanvasRenderingContext2D, colours: Colours, t: Transform, clip: Rect): void {
    const { chosen, pointed, uses } = this.store.state.placing;
    const all = this.footprints();
    for (const own of all) paintFootprint(context, t, own, own.file === chosen.image, own.file === pointed.image);
    const links = this.links();
    if (links !== null) {
      drawLinks(context, links, t, clip, uses);
      if (pointed.image === chosen.image && pointed.link !== null) drawRing(context, links, pointed.link, t, false);
      if (chosen.link !== null) drawRing(context, links, chosen.link, t, true);
    }
    this.paintEnd(context, t);
    paintCentres(context, colours, t, all, ({ file }) => file === chosen.image);
  }

  /** Places that were added and are not in the block yet; those of a coordinate reference system lie elsewhere. */
  private paintWaiting(context: CanvasRenderingContext2D, colours: Colours, t: Transform): void {
    const { shown, selection } = this.store.state;
    if (shown === null || shown.view.crs !== null || !takesPlaces(this.store.state)) return;
    context.save();
    for (const { name, position } of shown.given.filter(({ byHand }) => byHand)) {
      const at = toCanvas(t, position[0], -position[1]);
      const isChosen = selection.chosen?.kind === 'given' && selection.chosen.name === name;
      drawCross(context, at, isChosen ? SELECTED : CANDIDATE);
      context.font = '11px system-ui, sans-serif';
      context.textAlign = 'start';
      haloed(context, colours, name, at[0] + 9, at[1] - 6);
    }
    context.restore();
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

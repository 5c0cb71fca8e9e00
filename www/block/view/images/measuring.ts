/** Measures a point in the images that are shown: where it lies so far, where it is expected, and what a user does to it. */
import { crossing, onLine } from '../../../shared/state/neighbours';
import type { Position } from '../../../shared/state/pane';
import { Cancelled } from '../../../shared/engine/client';
import type { BlockEngine, BlockStore } from '../../engine/engine';
import type { Facts } from '../../engine/facts';
import { begun, isGiven, placed } from '../../state/draft';
import type { Draft } from '../../state/edited';
import { editsInForce, isEditable } from '../../state/editing';
import { indexOfSource, sourceOf } from '../../state/edits';
import { placesOfGiven } from '../../state/marks';
import { isMeasurable } from '../../state/point-kinds';
import { inOtherImage, placeOfGround } from '../../state/observed';
import { addedPoints } from '../../state/added';
import { pointsOf } from '../../state/selection';
import { isOn } from './scene';
import type { Pane } from './scene';
import { turnOf } from './turn';
import { say } from '../../../shared/text/words';
import { messageOf } from '../../../shared/text/messages';

/** Of a point that is placed in many images, the lines of the latest are drawn. */
const MOST_LINES = 2;
/** Images that are named one by one. */
const MOST_NAMES = 3;
const NOWHERE: ReadonlyMap<number, Position> = new Map();

export class Measuring {
  private matching = false;

  constructor(
    private readonly store: BlockStore,
    private readonly engine: BlockEngine,
    private readonly facts: Facts,
    private readonly panes: () => Pane[],
  ) {}

  get draft(): Draft | null {
    return this.store.state.draft;
  }

  /** Measures the chosen point, or a new one where none is chosen or `anew`; ends where a point is measured already. */
  toggle(anew: boolean): void {
    const { state } = this.store;
    if (state.draft !== null || !isEditable(state) || state.shown === null) {
      this.store.dispatch({ type: 'accept', leaves: true });
      return;
    }
    const { chosen } = state.selection;
    if (!anew && chosen?.kind === 'given') {
      this.set(begun({ given: chosen.name }));
      return;
    }
    const [point, ...more] = pointsOf(chosen);
    if (!anew && point !== undefined && !isMeasurable(state.shown.view, point)) return;
    const of = anew || point === undefined || more.length > 0 ? null : sourceOf(state.shown.view, point);
    if (of === null && !anew) return;
    if (of === null) this.store.dispatch({ type: 'choose', choice: null });
    // The point can be measured where it is not measured yet.
    else this.store.dispatch({ type: 'look', look: { unmeasured: true } });
    this.set(begun(of));
  }

  /** Whether what is chosen can be measured: a point. */
  canBegin(): boolean {
    const { selection, shown } = this.store.state;
    if (selection.chosen?.kind === 'given') return true;
    const [point] = pointsOf(selection.chosen);
    return shown !== null && point !== undefined && isMeasurable(shown.view, point);
  }

  /** Where the point lies in an image: where it was placed, else where it was measured before, else where it is expected. */
  placeIn(pane: Pane): Position | null {
    return this.draft?.places.get(pane.image)?.at ?? this.measured(pane.image) ?? this.expected(pane);
  }

  /** Where the point is expected in an image in which it is not placed: by its prediction, where the epipolar lines of two places cross, or by the points around it. */
  expected(pane: Pane): Position | null {
    const { draft } = this;
    if (draft === null || draft.places.has(pane.image)) return null;
    if (isGiven(draft.of) && this.known().has(pane.image)) return null;
    const elsewhere = this.detail()?.elsewhere.find(({ image }) => image === pane.image);
    if (elsewhere !== undefined) return [elsewhere.x_px, elsewhere.y_px];
    if (draft.of !== null && !isGiven(draft.of)) return null;
    // Two places say where the point is, whatever the ground around it is like.
    const [one, other] = this.sources(pane.image).map(({ image, at }) => this.facts.line(image, at, pane.image));
    const both = one == null || other == null ? null : crossing(one, other);
    if (both !== null) return both;
    const [first] = this.known();
    const from = first === undefined ? undefined : this.panes().find(({ image }) => image === first[0]);
    const near =
      this.ofGround(pane) ?? (first === undefined || from?.points == null || pane.points === null ? null : inOtherImage(from.points, pane.points, first[1]));
    if (first === undefined) return near;
    const line = this.facts.line(first[0], first[1], pane.image);
    return near === null || line === null ? near : onLine(line, near);
  }

  /** Where an image shows a control or check point that is chosen and not in the block, by its coordinates; null where these say nothing in the block. */
  ofGround(pane: Pane): Position | null {
    const { shown, selection } = this.store.state;
    const { chosen } = selection;
    if (shown === null || chosen?.kind !== 'given' || pane.points === null) return null;
    const place = shown.given.find(({ name }) => name === chosen.name)?.place;
    if (place == null) return null;
    const at = placeOfGround(pane.points, shown.view.points, [place[0], place[1]]);
    return at !== null && isOn(pane, at) ? at : null;
  }

  /** Where images show a given point by its measurements that hold, the first one first. */
  marks(): ReadonlyMap<number, Position> {
    const { shown, selection, options, marks } = this.store.state;
    if (shown === null || selection.chosen?.kind !== 'given') return NOWHERE;
    return this.added().get(selection.chosen.name)?.places ?? placesOfGiven(selection.chosen.name, shown.view, options.marks, marks);
  }

  /** The points that edits add. */
  private added() {
    const { shown, history } = this.store.state;
    return addedPoints(editsInForce(history), shown?.view.givenControl ?? 0);
  }

  /** Where the point that is chosen and measured is placed; nowhere while a new one is. */
  ownPlaces(): ReadonlyMap<number, Position> {
    const { draft } = this;
    return draft?.of == null ? NOWHERE : placesOf(draft);
  }

  /** The places of the draft, beside what was measured of a given point before. */
  known(): ReadonlyMap<number, Position> {
    const { draft } = this;
    if (draft === null) return NOWHERE;
    return new Map([...(isGiven(draft.of) ? this.marks() : []), ...placesOf(draft)]);
  }

  /** Places whose epipolar lines say where the point may lie in an image. */
  sources(image: number): { image: number; at: Position }[] {
    const others = [...this.known()].filter(([other]) => other !== image);
    return others.slice(-MOST_LINES).map(([other, at]) => ({ image: other, at }));
  }

  place(pane: Pane, at: Position): void {
    if (this.draft !== null) this.set(placed(this.draft, pane.image, at, pane));
  }

  nudge(pane: Pane, dx: number, dy: number): void {
    const at = this.placeIn(pane);
    if (at !== null) this.place(pane, [at[0] + dx, at[1] + dy]);
  }

  /** Places the point where it is expected, or at a place; where it is placed it is accepted. What says where it is expected may still be on its way. */
  async settle(pane: Pane, middle: Position): Promise<void> {
    const { draft } = this;
    if (draft === null) return;
    if (draft.places.has(pane.image) || this.measured(pane.image) !== null) return this.accept();
    let own: Pane | undefined = pane;
    let expected = this.expected(own);
    while (expected === null && this.facts.isAsked && (await this.facts.answered())) {
      // The user has gone on to something else.
      own = this.panes().find(({ image }) => image === pane.image);
      if (this.draft !== draft || own === undefined) return;
      expected = this.expected(own);
    }
    if (this.draft === draft) this.place(own, expected ?? middle);
  }

  accept(): void {
    this.store.dispatch({ type: 'accept', leaves: false });
  }

  /** Gives the measured point up; false where none is measured. */
  leave(): boolean {
    if (this.draft === null) return false;
    this.set(null);
    return true;
  }

  /** Moves the point in the other images to where least squares matching finds it by its place in one of them. */
  async match(from: Pane | null): Promise<void> {
    await this.matched(from, 'matching-in-the-other-images', async (of, at, file) => {
      const left = await this.engine.window(file, at, null);
      const others = this.panes().filter((pane) => pane.image !== of.image && pane.file !== null);
      const found = await Promise.all(
        others.map(async (pane) => {
          const near = this.placeIn(pane);
          if (near === null || pane.file === null) return null;
          const place = await this.engine.matched(left, pane.file.file, near, turnOf(of, pane, at));
          return { pane, place };
        }),
      );
      return () =>
        this.take(
          of,
          at,
          found.filter((one) => one !== null),
        );
    });
  }

  /** Moves the point in one image alone to where least squares matching finds it by another image that is shown and has it: by the first that confirms it. */
  async matchAlone(to: Pane | null): Promise<void> {
    await this.matched(to, 'matching-in-one-image', async (of, near, file) => {
      const others = this.others(of);
      for (const { pane, at, source } of others) {
        const left = await this.engine.window(source, at, null);
        const place = await this.engine.matched(left, file, near, turnOf(pane, of, at));
        if (place !== null) return () => this.takeAlone(of, place, pane);
      }
      const done = others.length === 0 ? say('no-other-has-the-point') : say('no-match-is-confirmed-in', { done: '', where: this.nameOf(of) }).trim();
      return () => this.tell('info', done);
    });
  }

  /** Does what matches the chosen or measured point by its place in an image. `job`: gives what takes its outcome, where the point is still the same. */
  private async matched(pane: Pane | null, busy: string, job: (pane: Pane, at: Position, file: Blob) => Promise<() => void>): Promise<void> {
    if (this.draft === null) this.toggle(false);
    const at = pane === null ? null : this.placeIn(pane);
    if (this.matching || this.draft === null || pane?.file == null || at === null) return;
    this.matching = true;
    const { draft } = this;
    this.tell('busy', say(busy, { image: this.nameOf(pane) }));
    try {
      const take = await job(pane, at, pane.file.file);
      // The user has gone on to something else.
      if (this.draft === draft) take();
      else if (this.store.state.notice?.kind === 'busy') this.store.dispatch({ type: 'notice', notice: null });
    } catch (error) {
      if (error instanceof Cancelled) this.tell('info', say('cancelled-nothing-was-matched'));
      else this.tell('problem', say('not-matched', { error: messageOf(error) }));
    }
    this.matching = false;
  }

  /** The other images that are shown and have the point, those first in which it is placed now. */
  private others(than: Pane): { pane: Pane; at: Position; source: Blob }[] {
    const places = this.draft?.places;
    const all = this.panes().flatMap((pane) => {
      const at = places?.get(pane.image)?.at ?? this.measured(pane.image);
      return pane.image === than.image || pane.file === null || at === null ? [] : [{ pane, at, source: pane.file.file }];
    });
    const isPlaced = ({ pane }: { pane: Pane }) => places?.has(pane.image) === true;
    return [...all.filter(isPlaced), ...all.filter((one) => !isPlaced(one))];
  }

  private nameOf({ image }: Pane): string {
    return this.store.state.shown?.view.images[image]?.name ?? '';
  }

  private takeAlone(pane: Pane, place: Position, by: Pane): void {
    if (this.draft !== null) this.set(placed(this.draft, pane.image, place, pane, 'least_squares'));
    this.tell('info', say('matched-in-one-image', { image: this.nameOf(pane), by: this.nameOf(by), what: say('enter-accepts') }));
  }

  private take(from: Pane, at: Position, found: readonly { pane: Pane; place: Position | null }[]): void {
    if (this.draft === null) return;
    // Of a new point the place that the others are matched to is one of its own.
    const isNew = this.draft.of === null || (isGiven(this.draft.of) && this.measured(from.image) === null);
    const own = isNew ? placed(this.draft, from.image, at, from) : this.draft;
    this.set(found.reduce((draft, { pane, place }) => (place === null ? draft : placed(draft, pane.image, place, pane, 'least_squares')), own));
    const lost = found.filter(({ place }) => place === null).map(({ pane }) => this.nameOf(pane));
    const count = found.length - lost.length;
    const done = say('matched-in-of-images', { count, found: found.length, what: count > 0 ? say('enter-accepts') : '' }).trim();
    const where = lost.length > MOST_NAMES ? say('images-4', { lost: lost.length }) : lost.join(', ');
    this.tell('info', lost.length === 0 ? done : say('no-match-is-confirmed-in', { done, where }));
  }

  /** Where the point was measured before, in an image. */
  private measured(image: number): Position | null {
    if (isGiven(this.draft?.of ?? null)) return this.marks().get(image) ?? null;
    const own = this.detail()?.observations.find((one) => one.image === image);
    return own === undefined ? null : [own.x_px, own.y_px];
  }

  private detail() {
    const { draft, shown } = this.store.state;
    if (draft?.of == null || isGiven(draft.of) || shown === null) return null;
    const point = indexOfSource(shown.view, draft.of);
    return point < 0 ? null : this.facts.point(point);
  }

  private set(draft: Draft | null): void {
    if (draft !== this.store.state.draft) this.store.dispatch({ type: 'draft', draft });
  }

  private tell(kind: 'info' | 'busy' | 'problem', text: string): void {
    this.store.dispatch({ type: 'notice', notice: { kind, text, beside: kind !== 'problem' } });
  }
}

function placesOf(draft: Draft): ReadonlyMap<number, Position> {
  return new Map([...draft.places].map(([image, { at }]) => [image, at]));
}

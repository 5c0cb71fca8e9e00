/** The answer of images that are placed on an orthophoto. */
import type { Answer, Figure, Next } from '../../shared/panel/answer';
import { count } from '../../shared/text/format';
import { gsdText, orthophotoText } from '../files/ground';
import { usedSo } from '../state/links';
import { placedFiles, unplacedFiles } from '../state/placed';
import { unitText } from '../../shared/text/units';
import { unitOfOrthophoto } from '../state/orthophoto-unit';
import type { LengthUnit } from '../state/orthophoto-unit';
import { purposeOf } from '../state/purpose';
import type { PlacedFile } from '../state/placed';
import type { BlockState } from '../state/state';
import { verdictText } from './placing-words';
import { say } from '../../shared/text/words';

export interface PlacingAnswerActions {
  place: () => void;
  /** Runs the images as a block and places that. */
  asBlock: () => void;
  /** Opens photos of one's own. */
  open: () => void;
  /** Asks for heights. */
  openHeights: () => void;
  save: () => void;
  /** Shows the table that says why. */
  why: () => void;
}

export function placingRuns({ done, total, text }: NonNullable<BlockState['placing']['running']>): Answer {
  const of = total > 1 ? say('of', { total: Math.min(total, done + 1), total_2: total }) : '';
  return { kind: 'busy', verdict: null, text: `${text}${of} …` };
}

export function placingAnswer(state: BlockState, actions: PlacingAnswerActions): Answer {
  const { placing, files } = state;
  const { orthophoto } = placing;
  const idle = (text: string, next: Next | null, more = ''): Answer => ({ kind: 'idle', verdict: null, text, more, next });
  // The invitation has the button.
  if (orthophoto === null) return idle(say('open-an-orthophoto-photographs-are'), null);
  const tried = placedFiles(state);
  if (tried.length > 0) return answered(state, tried, actions);
  const what = orthophotoText(orthophoto);
  if (files.length === 0) return idle(what, { text: say('open-photos'), act: actions.open }, heightsText(state));
  const text = say('can-be-placed', { files: images(files.length), what });
  const each: Next = { text: say(files.length < 2 ? 'place-on-the-orthophoto' : 'place-each-image'), act: actions.place };
  if (files.length < 2) return idle(text, each, heightsText(state));
  const block: Next = { text: say('place-them-as-a-block'), act: actions.asBlock };
  const [next, other] = purposeOf(state) === 'block' ? [block, each] : [each, block];
  return { ...idle(text, next, heightsText(state)), others: [other] };
}

/** Heights that lie under less of the orthophoto are said to. */
const MOSTLY = 0.95;

/** What the ground is taken for. */
export function heightsText({ placing: { heights, orthophoto } }: BlockState): string {
  const unit = unitText(unitOfOrthophoto(orthophoto));
  if (heights.kind === 'level') return say('its-ground-is-taken-as', { height: heights.height, unit });
  const [from, to] = orthophoto?.info.heights ?? [];
  const share = orthophoto?.info.heights_share ?? 1;
  const part = share < MOSTLY ? say('they-lie-under-of-the', { share: Math.round(100 * share) }) : '';
  const from_what = orthophoto?.info.heights_from ?? null;
  const given_in = orthophoto?.info.heights_given_in ?? null;
  return say('heights-of-to', { name: heights.model.name, from, to, unit, given_in, from_what, part });
}

function answered(state: BlockState, tried: readonly PlacedFile[], actions: PlacingAnswerActions): Answer {
  const of = (kind: string) => tried.filter(({ result }) => result?.verdict.kind === kind).length;
  const [placed, weak] = [of('placed'), of('weak')];
  const without = tried.length - placed - weak;
  const waiting = unplacedFiles(state).length;
  const stale = tried.filter(({ isStale }) => isStale).length;
  const [first] = tried;
  const text =
    tried.length === 1 && waiting <= stale && first !== undefined
      ? verdictText(first, state)
      : say('of-placed', {
          placed: placed + weak,
          tried: images(tried.length + Math.max(0, waiting - stale)),
          what: weak > 0 ? say('with-doubt', { weak, of: placed > 0 ? 'some' : weak > 1 ? 'all' : 'one' }) : '',
          what_2: without > 0 ? say('not-placed', { without }) : '',
        });
  const more = [
    // Of one image it is said already.
    tried.length > 1 ? reasonOf(tried, state) : '',
    stale > 0
      ? say('settings-heights-or-cameras-have', { what: stale === tried.length ? say('then') : say('placed', { stale: images(stale), stale_2: stale }) })
      : '',
    waiting > stale ? say('not-tried-yet-press-place', { waiting: images(waiting - stale) }) : '',
    state.placing.heights.kind === 'level' ? heightsText(state) : '',
  ];
  const isSound = without === 0 && weak === 0;
  const needsHeights = !isSound && state.placing.heights.kind === 'level';
  const save: Next = { text: say('save-positions-csv'), act: actions.save };
  const why: Next = needsHeights ? { text: say('open-heights'), act: actions.openHeights } : { text: say('show-why'), act: actions.why };
  const next: Next = waiting > 0 ? { text: say('place-them'), act: actions.place } : isSound ? save : why;
  return {
    kind: isSound ? 'done' : placed + weak > 0 ? 'partial' : 'problem',
    verdict: isSound ? 'oriented' : placed + weak > 0 ? 'weak' : 'not_oriented',
    text,
    more: more.filter((part) => part !== '').join(' '),
    figures: figuresOf(tried, unitOfOrthophoto(state.placing.orthophoto)),
    next,
  };
}

/** What speaks against the first image that is placed with doubt, or not at all; the others are in the details. */
function reasonOf(tried: readonly PlacedFile[], state: BlockState): string {
  const first = tried.find(({ result }) => result?.verdict.kind !== 'placed');
  return first === undefined ? '' : say('reason-of', { name: first.file.name, reason: verdictText(first, state) });
}

function figuresOf(tried: readonly PlacedFile[], unit: LengthUnit): Figure[] {
  const placements = tried.flatMap(({ result }) => result?.placement ?? []);
  const links = placements.reduce((sum, placement) => sum + usedSo(placement.links, 'used'), 0);
  const checks = placements.flatMap(({ checks: own }) => own ?? []);
  const number = checks.reduce((sum, own) => sum + own.number, 0);
  // The colour of the answer is the crate's verdict, of links and their residuals; how well that fixes where a camera stood depends on its field of view.
  const widths = tried.flatMap(({ result }) => (result?.verdict.kind === 'placed' ? [result.verdict.half_width_m] : []));
  const rmse = Math.sqrt(checks.reduce((sum, own) => sum + own.number * own.rmse_m ** 2, 0) / number);
  return [
    { value: say('of-2', { placements: placements.length, tried: tried.length }), label: say('images-placed') },
    ...(placements.length > 0 ? [{ value: count(links), label: say('links-3') }] : []),
    ...(widths.length > 0
      ? [{ value: say('within', { length: gsdText(Number(Math.max(...widths).toPrecision(2)), unit) }), label: say('projection-centres-95') }]
      : []),
    ...(number > 0 ? [{ value: gsdText(Number(rmse.toFixed(3)), unit), label: say('rmse-of-check-links-on') }] : []),
  ];
}

function images(number: number): string {
  return say('so-many-images', { images: number });
}

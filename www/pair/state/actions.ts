/** Everything that can happen to the state. */
import type { PaneView } from '../../shared/state/pane';
import type { CameraMm, Catalogue, FiducialModel, Flight, Settings, SamplePair } from '../../shared/crate';
import type { Notice } from '../../shared/state/notice';
import type { RestoredPair } from './kept';
import type { OpenedProject } from './project';
import type { Edit } from './edits';
import type {
  Area,
  Display,
  Draft,
  GivenImage,
  GivenMask,
  MarkInHand,
  MarkStep,
  MatchFilter,
  Outline,
  PhotoData,
  Selection,
  Side,
  StageFailure,
  StageName,
  StageResult,
  State,
  Tool,
  TypedPart,
} from './state';

export type StageDone = { [S in StageName]: { type: 'stageDone'; stage: S; result: StageResult<S> } }[StageName];

export type Action =
  | { type: 'ready'; catalogue: Catalogue }
  /** `same`: the sides whose new image has the same content as the one before it. */
  // `waits`: until Run is pressed. Null: no image any more.
  | { type: 'images'; images: Partial<Record<Side, GivenImage | null>>; same?: readonly Side[]; waits?: boolean }
  | { type: 'simulated'; left: GivenImage; right: GivenImage; pair: SamplePair }
  | { type: 'opened'; opened: OpenedProject }
  /** What the browser kept. */
  | { type: 'restored'; restored: RestoredPair }
  /** Nothing is on the page any more. */
  | { type: 'cleared' }
  /** Files of images that a project names. */
  | { type: 'found'; images: Partial<Record<Side, GivenImage>> }
  | { type: 'flight'; flight: Flight }
  | { type: 'swap' }
  | { type: 'settings'; settings: Settings }
  /** Of the fields of a part of the state, the one of this label holds a value that is not allowed; null where none does. */
  | { type: 'refused'; part: TypedPart; label: string | null }
  | { type: 'camera'; camera: CameraMm | null }
  | { type: 'photo'; side: Side; photo: Partial<PhotoData> }
  /** Fiducial marks change by hand; then: the first `done` of the steps hold from now on. */
  | { type: 'marked'; step: MarkStep }
  | { type: 'marksAfter'; done: number }
  | { type: 'mask'; side: Side; mask: GivenMask | null }
  /** An area was painted; then: the first `done` of the steps hold from now on, with the masks that they make. */
  | { type: 'painted'; step: { side: Side } & Area; mask: GivenMask }
  | { type: 'masksAfter'; done: number; masks: State['masks'] }
  | { type: 'fiducialModel'; model: FiducialModel }
  | { type: 'offset'; offset: [number, number] | null }
  | { type: 'stageStarted'; stage: StageName; key: string }
  | StageDone
  | { type: 'stageFailed'; stage: StageName; failure: StageFailure }
  | { type: 'stageStopped'; stage: StageName }
  | { type: 'cancelled' }
  | { type: 'resume' }
  /** Nothing is matched until the user asks for it, or changes something other than marks that are being measured. */
  | { type: 'wait' }
  | { type: 'select'; selection: Selection | null }
  /** Something is done to matches by hand. */
  | { type: 'edit'; edit: Edit }
  /** The first `done` of the edits hold from now on. */
  | { type: 'goto'; done: number }
  /** Matches are chosen together, by the keys of their targets. */
  | { type: 'choose'; chosen: readonly string[] }
  /** What is not kept by the filter is shown neither in the table of matches nor in the pictures. */
  | { type: 'filter'; filter: MatchFilter }
  | { type: 'tool'; tool: Tool }
  /** A match is measured by hand; null: no longer. */
  | { type: 'draft'; draft: Draft | null }
  /** An area is outlined; null: no longer. */
  | { type: 'outline'; outline: Outline | null }
  /** A fiducial mark is measured; null: no longer. */
  | { type: 'mark'; mark: MarkInHand | null }
  | { type: 'activeSide'; side: Side }
  | { type: 'views'; views: Partial<Record<Side, PaneView | null>> }
  | { type: 'display'; display: Partial<Display> }
  | { type: 'notice'; notice: Notice | null };

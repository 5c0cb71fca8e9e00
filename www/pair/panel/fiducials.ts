/** Fiducial marks of one photo: a table to type into, or a CSV file. */
import { scrolledByKeys } from '../../shared/panel/scrolled';
import { allowedOfOrigin } from '../engine/checks';
import type { Fiducial } from '../../shared/crate';
import { nameOfMarkStep } from '../state/mark-steps';
import type { Marking } from '../state/marking';
import { isWhole, wholeMarks, withCoordinatesOf } from '../state/marks';
import { otherSide } from '../state/state';
import type { Side, State } from '../state/state';
import type { Store } from '../state/store';
import { button, fill, h } from '../../shared/panel/dom';
import { passFocus } from '../../shared/panel/focus';
import { showSteps } from '../../shared/panel/history';
import { fixed } from '../../shared/text/format';
import { firstRefused, numberInput, problemLine, readPair, showNumber } from '../../shared/panel/numberfield';
import { say } from '../../shared/text/words';
import { unitText } from '../../shared/text/units';
import { declareLack } from '../../shared/panel/lack';

const FIELDS = ['col', 'row', 'x_mm', 'y_mm'] as const;
const HEADS: Record<(typeof FIELDS)[number], string> = { col: say('col-px'), row: say('row-px'), x_mm: `x ${unitText('mm')}`, y_mm: `y ${unitText('mm')}` };

/** `measure`: in the picture of a side. */
export function mountFiducials(host: HTMLElement, store: Store, loadFile: (side: Side) => void, marking: Marking, measure: (side: Side) => void): void {
  const model = h('select', { id: 'fiducial-model', testid: 'fiducial-model' });
  model.append(new Option(say('affine-6-parameters'), 'affine'), new Option(say('similarity-4-parameters'), 'similarity'));
  model.addEventListener('change', () => {
    store.dispatch({ type: 'fiducialModel', model: model.value === 'similarity' ? 'similarity' : 'affine' });
  });
  store.watch(['fiducialModel'], ([value]) => {
    model.value = value;
  });
  host.append(
    h(
      'fieldset',
      { class: 'group', testid: 'fiducials' },
      h('legend', {}, say('interior-orientation')),
      h('div', { class: 'control' }, h('label', { for: 'fiducial-model' }, say('transformation')), model),
      photo('left', store, loadFile, marking, measure),
      photo('right', store, loadFile, marking, measure),
    ),
  );
}

function photo(side: Side, store: Store, loadFile: (side: Side) => void, marking: Marking, measure: (side: Side) => void): HTMLElement {
  const table = scrolledByKeys(h('div', { class: 'scroll fiducials-table' }));
  const result = h('p', { class: 'note', testid: `interior-${side}` });
  const name = say('image-4', { name: side === 'left' ? say('left') : say('right') });
  const add = button(say('add-mark'), `add-fiducial-${side}`, () => marking.add(side));
  const load = button(say('load-csv'), `load-fiducials-${side}`, () => loadFile(side));
  const inPicture = button(say('measure-in-the-image'), `measure-fiducials-${side}`, () => measure(side), say('press-each-mark-in-the-image'));
  store.watch(
    (s) => [s.images[side], s.tool, s.mark] as const,
    ([image, tool, mark]) => {
      inPicture.disabled = image === null;
      inPicture.setAttribute('aria-pressed', String(tool === 'fiducials' && mark?.side === side));
    },
  );
  const other = otherSide(side);
  const asOther = button(
    say('as-in-the-other-image', { side: other }),
    `coordinates-fiducials-${side}`,
    () => marking.takeCoordinates(side),
    say('takes-the-photo-coordinates', { side: other }),
  );
  store.watch(
    (s) => [s.photos.left.fiducials, s.photos.right.fiducials] as const,
    ([left, right]) => {
      const [own, others] = side === 'left' ? [left, right] : [right, left];
      const held = asOther === document.activeElement ? asOther : null;
      asOther.hidden = withCoordinatesOf(own, others) === null;
      passFocus(held, [asOther, inPicture]);
    },
  );
  const clear = button(say('clear'), `clear-fiducials-${side}`, () => marking.removeAll(side));
  declareLack([inPicture], () => (store.state.images[side] === null ? say('needs-a-photo') : ''));
  declareLack([clear], () => (store.state.photos[side].fiducials.length === 0 ? say('nothing-is-measured') : ''));
  const undo = button(say('undo-sign'), `undo-fiducials-${side}`, () => marking.step(-1));
  const redo = button(say('redo-sign'), `redo-fiducials-${side}`, () => marking.step(1));
  let shown: readonly Fiducial[] | null = null;
  const stage = side === 'left' ? 'interiorLeft' : 'interiorRight';
  store.watch(
    (s) => [s.markSteps, s.images] as const,
    ([history, images]) => {
      const held = [undo, redo].find((press) => press === document.activeElement) ?? null;
      showSteps(undo, redo, history, (step) => nameOfMarkStep(step, images));
      // Beside the table of what they would change.
      undo.hidden = history.edits[history.done - 1]?.side !== side;
      redo.hidden = history.edits[history.done]?.side !== side;
      passFocus(held, [undo, redo, add]);
    },
  );
  store.watch(
    (s) => [s.photos[side].fiducials, s.results[stage], isPixelMissing(s, side)] as const,
    ([fiducials, interior, isWithoutPixel]) => {
      const held = table.contains(document.activeElement) || clear === document.activeElement ? document.activeElement : null;
      const whole = fiducials.filter(isWhole).length;
      const residuals = interior?.value.fiducials?.residuals_mm ?? [];
      // A result that comes leaves the fields alone: one may hold what is being typed.
      if (shown !== fiducials) {
        // Typing a number changes one mark: the table is built anew only when marks come or go, so that the focus stays.
        if (shown?.length !== fiducials.length) fill(table, marksTable(side, marking, fiducials.length));
        shown = fiducials;
        showMarks(table, fiducials);
      }
      showResiduals(table, fiducials, residuals.length === whole ? residuals : []);
      clear.disabled = fiducials.length === 0;
      // Keys take back what was pressed.
      passFocus(held, [undo, add]);
      const incomplete = fiducials.length - whole;
      const { sigma0_mm, degrees_of_freedom } = interior?.value.fiducials ?? {};
      const told = isWithoutPixel ? say('no-fiducial-marks-and-no-pixel') : interiorText(sigma0_mm, degrees_of_freedom, whole);
      fill(result, incomplete === 0 ? told : `${told} ${say('incomplete-marks', { incomplete })}`);
    },
  );
  return h(
    'div',
    { class: 'photo twin', role: 'group', aria: { label: name } },
    h('h3', {}, name),
    result,
    table,
    h('div', { class: 'buttons' }, inPicture, add, asOther, load, clear, undo, redo),
    originFields(side, store),
  );
}

/** Whether neither marks nor a pixel size lead from px of a photo to mm. */
function isPixelMissing({ camera, photos, results }: State, side: Side): boolean {
  const ofFile = results[side === 'left' ? 'openLeft' : 'openRight']?.value.info.camera;
  return wholeMarks(photos[side]).length === 0 && (camera ?? ofFile)?.pixel_mm == null;
}

function interiorText(sigma: number | null | undefined, freedom: number | undefined, marks: number): string {
  if (marks === 0) return say('no-fiducial-marks-the-pixel');
  if (freedom === undefined) return say('marks', { marks });
  return say('marks-degrees-of-freedom', { marks, what: sigma == null ? say('not-determined') : say('um-1', { value: 1000 * sigma }), freedom });
}

function marksTable(side: Side, marking: Marking, rows: number): HTMLElement | string {
  if (rows === 0) return '';
  const body = Array.from({ length: rows }, (_, i) =>
    h(
      'tr',
      {},
      h('th', { scope: 'row' }, String(i + 1)),
      ...FIELDS.map((field) => h('td', {}, markInput(side, marking, i, field))),
      h('td', { class: 'number residual' }, h('span', {})),
      h('td', {}, removeButton(side, marking, i)),
    ),
  );
  return h(
    'table',
    { class: 'marks', testid: `fiducials-${side}`, aria: { label: say('fiducial-marks', { side }) } },
    h(
      'thead',
      {},
      h(
        'tr',
        {},
        h('td', {}, ''),
        ...FIELDS.map((field) => h('th', { scope: 'col' }, HEADS[field])),
        h('th', { scope: 'col', class: 'residual', title: say('residuals-vx-vy') }, h('span', {}, `v ${unitText('µm')}`)),
        h('td', {}, ''),
      ),
    ),
    h('tbody', {}, ...body),
  );
}

function markInput(side: Side, marking: Marking, index: number, field: (typeof FIELDS)[number]): HTMLInputElement {
  const input = h('input', { type: 'number', aria: { label: say('mark', { index: index + 1, heads: HEADS[field] }) } });
  input.step = 'any';
  input.addEventListener('change', () => marking.type(side, index, { [field]: input.valueAsNumber }));
  return input;
}

function removeButton(side: Side, marking: Marking, index: number): HTMLButtonElement {
  const remove = button('×', `remove-fiducial-${side}-${String(index)}`, () => marking.remove(side, index));
  remove.className = 'icon';
  remove.setAttribute('aria-label', say('remove-mark', { index: index + 1 }));
  return remove;
}

function showMarks(table: HTMLElement, fiducials: readonly Fiducial[]): void {
  table.querySelectorAll('tbody tr').forEach((line, i) => {
    line.querySelectorAll('input').forEach((input, f) => {
      const field = FIELDS[f];
      const value = field === undefined ? undefined : fiducials[i]?.[field];
      if (value === undefined || Object.is(input.valueAsNumber, value)) return;
      input.value = Number.isFinite(value) ? String(value) : '';
    });
  });
}

/** `residuals`: of the marks that take part, in their order. */
function showResiduals(table: HTMLElement, fiducials: readonly Fiducial[], residuals: readonly [number, number][]): void {
  const parts = fiducials.map((mark, i) => (isWhole(mark) ? residuals[fiducials.slice(0, i).filter(isWhole).length] : undefined));
  table.querySelectorAll('tbody tr').forEach((line, i) => {
    const cell = line.querySelector('.residual span');
    const [vx, vy] = parts[i] ?? [];
    if (cell !== null) cell.textContent = vx === undefined ? '' : `${fixed(1000 * vx, 0)}, ${fixed(1000 * (vy ?? NaN), 0)}`;
  });
}

/** Where the image lies in the scan whose marks were measured. */
function originFields(side: Side, store: Store): HTMLElement {
  const problem = problemLine(`origin-${side}`);
  const change = () => {
    const origin = readPair(inputs, problem, allowedOfOrigin);
    if (origin !== undefined) store.dispatch({ type: 'photo', side, photo: { origin } });
    store.dispatch({ type: 'refused', part: 'photos', label: firstRefused(inputs.map((input) => [say('origin-of-the-image-in', { side }), input])) });
  };
  const field = (name: string, testid: string) => {
    const input = numberInput(testid, problem, change);
    input.setAttribute('aria-label', say('image-in-the-scan-px', { side, name }));
    return input;
  };
  const inputs = [field('column', `origin-${side}-col`), field('row', `origin-${side}-row`)] as const;
  store.watch(
    (s) => [s.photos[side].origin] as const,
    ([origin]) => {
      inputs.forEach((input, axis) => {
        showNumber({ input, problem }, origin?.[axis]);
      });
    },
  );
  return h(
    'div',
    { class: 'control compact origin' },
    h('span', { title: say('column-and-row-of-this') }, say('origin-in-the-scan'), h('span', { class: 'unit' }, say('col-row-px'))),
    ...inputs,
    problem,
  );
}

/** What is given of scanned film: its camera, and the fiducial marks of each scan, by which scans are placed on an orthophoto, or become images of a block. */
import { button, fill, h } from '../../shared/panel/dom';
import { passFocus } from '../../shared/panel/focus';
import { set } from '../../shared/panel/history';
import { fileButton } from '../../shared/panel/picker';
import { say } from '../../shared/text/words';
import type { BlockStore } from '../engine/engine';
import type { BlockFiles } from '../files/files';
import { framesOf, marksOfNone, possibleScans } from '../state/film';
import { isFramesStep } from '../state/marks';
import { nameOfMarks } from '../state/naming';
import { timelineOf } from '../state/timeline';
import { stepBy } from './edits';
import { countedScans, marksFarOff } from '../state/scan-marks';
import { isBusy } from '../state/state';
import { declareLack } from '../../shared/panel/lack';
import { lackOfImages } from '../state/lacks';

/** Names of marks that are listed, at most. */
const LISTED = 3;

/** `measureMarks`: in the pictures of scans that have none yet. */
export function filmFields(store: BlockStore, files: BlockFiles, measureMarks: () => void): HTMLElement {
  const { film: taken } = files;
  const [camera, cameraInput] = fileButton(
    `${say('film-camera')} …`,
    { testid: 'block-film-camera', label: say('file', { title: say('film-camera') }), accept: '.json,application/json' },
    ([file]) => {
      if (file !== undefined) void taken.takeCamera(file);
    },
  );
  const [marks, marksInput] = fileButton(
    `${say('marks-of-scans')} …`,
    { testid: 'block-film-marks', label: say('file', { title: say('marks-of-scans') }), multiple: true, accept: '.csv,.txt,text/*' },
    (given) => void taken.takeMarks(given),
  );
  const measure = button(`${say('measure-marks')} …`, 'block-film-measure', measureMarks, say('measure-marks-help'));
  const remove = button(say('remove'), 'block-film-remove', () => taken.clear());
  remove.setAttribute('aria-label', say('remove-2', { title: say('scanned-film') }));
  const frames = button(say('make-frames'), 'block-film-frames', () => void files.actions.frames());
  declareLack([measure], () => lackOfImages(store.state));
  declareLack([frames], () => {
    const { film } = store.state.placing;
    return film.camera === null || film.marks.length === 0 ? say('needs-marked-scans') : '';
  });
  const undo = button('', 'block-film-undo', () => {
    stepBy(store, -1);
    passFocus(undo, [frames]);
  });
  const cameraName = h('p', { class: 'note', testid: 'block-film-camera-name' });
  const marksNames = h('p', { class: 'note', testid: 'block-film-marks-names' });
  const counted = h('p', { class: 'note', testid: 'block-film-counted' });
  const problem = h('p', { class: 'field-problem', testid: 'block-film-problem' });
  store.watch(['placing', 'files', 'running', 'notice'], ([{ film, placed }, images]) => {
    const busy = isBusy(store.state);
    for (const press of [camera, marks, remove]) press.disabled = busy;
    measure.disabled = busy || possibleScans(images).length === 0;
    remove.hidden = film.camera === null && film.marks.length === 0 && !film.areScans;
    const count = countedScans(film, images);
    counted.hidden = count.scans === 0;
    fill(counted, say('marks-of-some-scans', count));
    const scans = framesOf(film, images);
    // What was placed would be lost.
    frames.disabled = busy || film.camera === null || scans.length === 0 || scans.some(({ id }) => placed.has(id));
    fill(cameraName, film.camera?.name ?? say('none-film-camera', { example: '{"focal_mm": 152.82, "principal_point_mm": [0.004, -0.012]}' }));
    const names = film.marks.slice(0, LISTED).map(({ name }) => name);
    const more = film.marks.length > LISTED ? ' …' : '';
    fill(marksNames, names.length === 0 ? say('none-marks-of-scans', { example: '1963_017.csv', image: '1963_017.tif' }) : names.join(', ') + more);
    const [lone] = marksOfNone(film, images);
    const lacksCamera = film.marks.length > 0 && film.camera === null ? say('marks-need-their-camera') : '';
    const text = lone !== undefined ? say('marks-of-no-image', { name: lone }) : lacksCamera || marksFarOff(film.marks, images);
    if (problem.textContent !== text) problem.textContent = text;
  });
  store.watch(['history', 'marks', 'draft', 'running', 'notice'], ([, marks, draft]) => {
    const { edits, done } = timelineOf(store.state);
    const last = edits[done - 1];
    const step = last?.of === 'marks' ? marks.edits[last.at] : undefined;
    // Where nothing was done since; what is measured would be taken back first.
    const isLast = step !== undefined && isFramesStep(step) && draft === null;
    undo.hidden = !isLast;
    set(undo, isLast ? say('undo-3', { undo: nameOfMarks(step) }) : '', isBusy(store.state));
  });
  return h(
    'fieldset',
    { class: 'group' },
    h('legend', {}, say('scanned-film')),
    h(
      'div',
      { class: 'control' },
      h('div', { class: 'buttons' }, camera, marks, measure, remove),
      cameraName,
      marksNames,
      counted,
      problem,
      cameraInput,
      marksInput,
    ),
    h('div', { class: 'control' }, h('div', { class: 'buttons' }, frames, undo), h('p', { class: 'help' }, say('make-frames-help'))),
  );
}

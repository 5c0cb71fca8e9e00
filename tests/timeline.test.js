/** Edits of a block, measurements of control points and images taken out as one history: without a browser. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { pageModules } from './www.js';

const {
  history: { recorded, wentTo },
  timeline: { heldAt, timelineOf },
} = await pageModules(['block/state/timeline', 'shared/state/history']);

const NONE = { edits: [], done: 0 };

/** @typedef {{ history: { edits: any[], done: number }, marks: { edits: any[], done: number } }} Both */

/** As the page records steps: `e` an edit, `m` a step beside it, `-` undone, `+` done again.  @param {string} steps @returns {Both} */
function after(steps) {
  let both = { history: NONE, marks: NONE };
  let named = 0;
  for (const step of steps) {
    if (step === 'e' || step === 'm') named += 1;
    if (step === 'e') both = { ...both, history: recorded(both.history, [{ kind: 'reject_points', name: `e${named}` }]) };
    else if (step === 'm') both = { ...both, marks: recorded(both.marks, { kind: 'measure', name: `m${named}`, after: both.history.done }) };
    else {
      const place = timelineOf(both).done + (step === '-' ? -1 : 1);
      const held = heldAt(both, place);
      assert.equal(held.edits + held.marks, place);
      both = { history: wentTo(both.history, held.edits), marks: wentTo(both.marks, held.marks) };
    }
  }
  return both;
}

/** The names of all steps, those that do not hold in brackets.  @param {Both} both */
function named(both) {
  const { edits, done } = timelineOf(both);
  const name = (/** @type {{ of: string, at: number }} */ { of, at }) => (of === 'edits' ? both.history.edits[at][0].name : both.marks.edits[at].name);
  return edits.map((/** @type {any} */ step, /** @type {number} */ i) => (i < done ? name(step) : `(${name(step)})`)).join(' ');
}

test('steps of both stand in the order in which they were made, and are undone and done again in it', () => {
  assert.equal(named(after('')), '');
  assert.equal(named(after('memme')), 'm1 e2 m3 m4 e5');
  const steps = 'memme';
  for (let undone = 0; undone <= steps.length; undone += 1) {
    const both = after(steps + '-'.repeat(undone));
    assert.equal(timelineOf(both).done, steps.length - undone);
    assert.deepEqual(named(both).replaceAll(/[()]/gu, ''), 'm1 e2 m3 m4 e5');
    assert.deepEqual(after(`${steps}${'-'.repeat(undone)}${'+'.repeat(undone)}`), after(steps));
  }
  // Before the first one nothing is undone.
  assert.deepEqual(heldAt(after('m-'), -1), { edits: 0, marks: 0 });
});

test('a step that is made after others were undone stands before those of the other kind that are still undone', () => {
  assert.equal(named(after('em--m')), 'm3 (e1)');
  assert.equal(named(after('me--e')), 'e3 (m1)');
});

test('every place of the list is gone to with the edits and the steps beside them that hold there', () => {
  const both = after('memme');
  assert.deepEqual(
    [0, 1, 2, 3, 4, 5, 9].map((place) => heldAt(both, place)),
    [
      { edits: 0, marks: 0 },
      { edits: 0, marks: 1 },
      { edits: 1, marks: 1 },
      { edits: 1, marks: 2 },
      { edits: 1, marks: 3 },
      { edits: 2, marks: 3 },
      { edits: 2, marks: 3 },
    ],
  );
  // The same as when they are undone one by one.
  for (let place = 0; place <= 5; place += 1) {
    const there = after(`memme${'-'.repeat(5 - place)}`);
    assert.deepEqual({ edits: there.history.done, marks: there.marks.done }, heldAt(both, place));
  }
});

test('a history whose edits were undone without the steps after them still goes back and on to its ends', () => {
  // An earlier release went back in the list of edits alone.
  const both = { ...after('em'), history: wentTo(after('em').history, 0) };
  assert.equal(named(both), 'm2 (e1)');
  assert.deepEqual(heldAt(both, 0), { edits: 0, marks: 0 });
  assert.deepEqual(heldAt(both, 2), { edits: 1, marks: 1 });
});

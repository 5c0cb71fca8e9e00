/** The search for actions finds words however they are written. Without a browser. */

import assert from 'node:assert/strict';
import { before, test } from 'node:test';
import { pageModules } from './www.js';

/** @type {(text: string) => string} */
let folded;

before(async () => {
  ({ folded } = (await pageModules(['shared/text/folded'])).folded);
});

test('marks, hamza, tatweel and letters that are written as others make no difference', () => {
  for (const [written, sought] of [
    ['المكبّرة', 'مكبر'],
    ['المكبّرة', 'المكبره'],
    ['أقنعة', 'اقنعة'],
    ['إظهار الكل', 'اظهار'],
    ['آخر', 'اخر'],
    ['مدى', 'مدي'],
    ['مســـح', 'مسح'],
    ['Épipolar LINES', 'epipolar'],
  ])
    assert.ok(folded(written ?? '').includes(folded(sought ?? '')), `${written} ${sought}`);
  assert.ok(!folded('قناع').includes(folded('صورة')));
});

/** Texts of files in the encodings of spreadsheets. */

import assert from 'node:assert/strict';
import { test } from 'node:test';
import { textOf } from '../pkg/block/text-of.js';

const TEXT = 'Bild;Länge;Höhe\nStraße_1.jpg;8,25;171,5\n';

test('a text is read in UTF-8, in UTF-16 where it is marked so, and else as older spreadsheets save it', () => {
  const bigEndian = Buffer.from(`\ufeff${TEXT}`, 'utf16le').swap16();
  const files = [TEXT, `\ufeff${TEXT}`]
    .map((text) => Buffer.from(text))
    .concat(Buffer.from(`\ufeff${TEXT}`, 'utf16le'), bigEndian, Buffer.from(TEXT, 'latin1'));
  for (const file of files) assert.equal(textOf(file), TEXT);
});

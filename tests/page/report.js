/** Reports as people open them: files, by themselves. */

import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';

/** Opens a report as a file in a tab of its own.  @param {import('playwright-core').Page} page @param {Uint8Array} report */
export async function reportTab(page, report) {
  const file = join(mkdtempSync(join(tmpdir(), 'tiepoint-report-')), 'report.html');
  writeFileSync(file, report);
  const tab = await page.context().newPage();
  await tab.goto(pathToFileURL(file).href);
  return tab;
}

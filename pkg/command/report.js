// @ts-check
import { withText } from '../messages.js';
import { defaults, message, Report } from '../node.js';
import { basename } from 'node:path';
import { checkSize } from './block-camera.js';
import { UsageError, VERDICT_CODES } from './errors.js';
import { makeFolder, readPhoto, writeInto } from './files.js';
import { JSON_FLAG, LANGUAGE, languageOf, path, SETTING_OPTIONS, settingsOf } from './options.js';
import { print, printJson } from './output.js';
import { inputOf, MASK_OPTIONS, masksOf, PAIR_OPTIONS } from './pair.js';
import { Progress } from './progress.js';
import { checkPair, readTruth } from './truth.js';

const OPTIONS = [
  path('out', 'DIR', 'Folder that receives report.html; required.'),
  ...PAIR_OPTIONS,
  ...MASK_OPTIONS,
  path('truth', 'FILE', 'truth.json of a simulated pair, or its folder: matches and orientation are compared with it.'),
  LANGUAGE,
  JSON_FLAG,
  ...SETTING_OPTIONS,
];

/** @type {import('./args.js').Command} */
export const report = {
  name: 'report',
  summary: 'Matches and orients a pair by every strategy and writes one self-contained HTML report with pictures and tables.',
  positionals: ['LEFT', 'RIGHT'],
  options: OPTIONS,
  details:
    "The options are those of `tiepoint match`. The report holds the images with their points, the paper's Tables 1 to 3 for all strategies beside the " +
    'printed values, residuals, reliability and parameters. The exit code is that of the verdict on the run by these options, as of `tiepoint match`. JSON: verdict, file.',
  run(call) {
    const {
      positionals: [leftPath = '', rightPath = ''],
      values,
    } = call;
    const { input, ofBlock } = inputOf(call);
    const settings = settingsOf(OPTIONS, values, defaults());
    const [out, truthPath, language] = [values.get('out'), values.get('truth'), languageOf(values)];
    if (typeof out !== 'string') throw new UsageError('--out is missing: name the folder that receives the report');
    const truth = typeof truthPath === 'string' ? readTruth(truthPath) : null;
    makeFolder(out);
    const reading = new Progress({ steps: 2 });
    const left = reading.step(`reading ${leftPath}`, () => readPhoto(leftPath));
    const right = reading.step(`reading ${rightPath}`, () => readPhoto(rightPath));
    reading.end();
    checkSize(ofBlock, [left, right]);
    if (truth) checkPair(truth, left, right);
    const made = new Report(left, right, [basename(leftPath), basename(rightPath)], input, settings, truth, ...masksOf(call, left, right));
    const progress = new Progress({ steps: made.steps().length + 1, quiet: values.has('json') });
    for (const step of made.steps()) progress.step(`matching: ${step}`, () => made.step());
    const file = progress.step('writing', () => writeInto(out, 'report.html', made.html(language)));
    progress.end();
    const verdict = /** @type {import('../node.js').PairVerdict} */ (made.verdict());
    if (values.has('json')) printJson({ verdict: withText('pair_verdict', verdict), file });
    else print(message('pair_verdict', verdict), '', `written: ${file}`);
    return VERDICT_CODES[verdict.kind];
  },
};

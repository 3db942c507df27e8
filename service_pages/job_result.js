// What a job found: its lights, pictures, measurements and files.
import { fileAddress, get } from './api.js';
import { checkLine, checkLines, sign } from './checks_list.js';
import { byId, make, tellProblem } from './dom.js';
import { evaluationTable } from './evaluation_table.js';
import { measurementTables } from './measurement_table.js';
import { checksOf, labelPictures, resultOf } from './results.js';

const kFileWords = {
  'report.html': 'the report', 'result.json': 'all numbers', 'measurements.csv': 'one row per dimension',
  'labels.u8': 'one byte per vertex', 'segmented.ply': 'the scan with its labels', 'segmented.glb': 'the same for viewers',
  'filled.ply': 'the scan with holes closed', 'borders.json': 'lines along the borders', 'state.bin': 'the prepared scan, for another fit',
  'evaluation.html': 'the page', 'evaluation.json': 'all figures', 'evaluation.csv': 'one row per scan and dimension',
};

const showFiles = (job) => {
  byId('files-box').hidden = job.files.length === 0;
  const pictures = job.files.filter((file) => file.startsWith('pictures/') || file.startsWith('fits/'));
  const link = (file) => make('li', {}, make('a', { href: fileAddress(job.id, file), textContent: file }),
    ...(kFileWords[file] ? [make('span', { className: 'note', textContent: kFileWords[file] })] : []));
  byId('files').replaceChildren(...job.files.filter((file) => !pictures.includes(file)).map(link));
  if (pictures.length === 0) return;
  byId('files').append(make('li', { className: 'more' }, make('details', {},
    make('summary', { textContent: `${pictures.length} more below folders` }), make('ul', { className: 'files' }, ...pictures.map(link)))));
};

const showLinks = (job, has) => {
  const links = [];
  if (job.links.report) links.push(make('a', { className: 'main', href: job.links.report, textContent: 'Open the report' }));
  if (has('result.json')) links.push(make('a', { href: `/jobs/${job.id}/correct`, textContent: 'Correct it on the picture' }));
  if (has('measurements.csv')) links.push(make('a', { href: fileAddress(job.id, 'measurements.csv'), textContent: 'Measurements as CSV' }));
  byId('links').replaceChildren(...links);
};

const showVerdict = (verdict) => {
  byId('state-box').className = `verdict state-box ${verdict.level}`;
  byId('state-title').replaceChildren(sign(verdict.level), verdict.headline);
  byId('remarks').replaceChildren(...verdict.warnings.map((text) => make('li', { textContent: text })));
  const lines = verdict.checks.filter(({ level }) => level !== 'good');
  const good = verdict.checks.length - lines.length;
  byId('lights').replaceChildren(...checkLines(lines),
    ...(good > 0 ? [checkLine('good', good === 1 ? 'One check' : `${good} checks`)] : []));
};

export const showResult = async (job) => {
  const has = (file) => job.files.includes(file);
  showFiles(job);
  showLinks(job, has);
  byId('glance').replaceChildren(...labelPictures(job.id, job.files));
  try {
    if (has('evaluation.json')) byId('measured').replaceChildren(evaluationTable(await get(fileAddress(job.id, 'evaluation.json'))));
    if (!has('result.json')) return;
    const [result, checks] = await Promise.all([resultOf(job.id), checksOf(job.id)]);
    const before = job.source ? await resultOf(job.source).catch(() => undefined) : undefined;
    showVerdict(checks);
    byId('measured').replaceChildren(...measurementTables(result, before));
  } catch (error) {
    tellProblem(error);
  }
};

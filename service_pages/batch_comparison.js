// The results of a batch beside a table of truth.
import { get } from './api.js';
import { byId, cm, make, signedCm } from './dom.js';
import { resultOf } from './results.js';

// Rows of a CSV text by the names of its head.
export const readCsv = (text) => {
  const rows = [[]];
  for (const [, quoted, plain, end] of text.matchAll(/(?:"((?:[^"]|"")*)"|([^,\r\n]*))(,|\r?\n|$)/gy)) {
    rows.at(-1).push(quoted?.replaceAll('""', '"') ?? plain);
    if (end === '') break;
    if (end !== ',') rows.push([]);
  }
  const [head, ...body] = rows.filter((row) => row.some((cell) => cell !== ''));
  return (body ?? []).map((row) => Object.fromEntries(head.map((name, i) => [name.trim().replace(/^\uFEFF/, ''), (row[i] ?? '').trim()])));
};

// As tables of the command line name scans: a path, a file name, or a stem that may mean several.
const means = (scan, file) => {
  const name = scan.split(/[\\/]/).at(-1);
  return name !== '' && (file === name || file.startsWith(`${name}.`));
};

const jobsOf = async (batch) => {
  const all = [];
  let after = '';
  do {
    const query = new URLSearchParams({ batch, state: 'succeeded', limit: '200', ...(after ? { after } : {}) });
    const { jobs, next } = await get(`/v1/jobs?${query}`);
    all.push(...jobs.filter(({ kind }) => kind === 'fit' || kind === 'refit'));
    after = next;
  } while (after);
  return all;
};

const pairsOf = (job, result, truth) => {
  const of = truth.filter((row) => means(row.scan, job.name));
  return result.garments.flatMap((garment) => garment.measurements.flatMap((m) => {
    const row = of.find((one) => one.measurement === m.name && one.template === garment.template
      && (!one.layer || Number(one.layer) === garment.layer));
    const value = Number(row?.value_cm || row?.ground_truth_cm || NaN);
    if (!(value > 0)) return [];
    return [{ job, title: `${garment.title}: ${m.title}`, observable: m.observable, value: m.value_cm, truth: value,
      error: m.value_cm - value, inside: m.interval_cm[0] <= value && value <= m.interval_cm[1] }];
  }));
};

const cell = (name, text) => make('td', { className: 'n', data: { name }, textContent: text });

const sumRow = (title, pairs) => {
  const mean = (of) => pairs.reduce((sum, pair) => sum + of(pair), 0) / pairs.length;
  const worst = pairs.reduce((most, { error }) => (Math.abs(error) > Math.abs(most) ? error : most), 0);
  return make('tr', {}, make('th', { scope: 'row', textContent: title }), cell('Scans', String(pairs.length)),
    cell('Mean error, cm', signedCm(mean(({ error }) => error))), cell('Mean of |error|, cm', cm(mean(({ error }) => Math.abs(error)))),
    cell('Worst, cm', signedCm(worst)), cell('In its 90 %', `${Math.round(100 * mean(({ inside }) => Number(inside)))} %`));
};

// Shows the tables; returns what was compared, in words. Throws when there is nothing to compare.
export const compareJobs = async (batch, text) => {
  const truth = readCsv(text);
  if (!truth[0] || !['scan', 'template', 'measurement'].every((name) => name in truth[0])) {
    throw new Error('The table needs the columns scan, template, measurement and value_cm.');
  }
  // A scan that was corrected counts by its newest result.
  const newest = new Map();
  for (const job of await jobsOf(batch)) if (!newest.has(job.name)) newest.set(job.name, job);
  const pairs = [];
  for (const job of newest.values()) pairs.push(...pairsOf(job, await resultOf(job.id), truth));
  const seen = pairs.filter(({ observable }) => observable);
  byId('compared').hidden = pairs.length === 0;
  if (pairs.length === 0) throw new Error('No scan of the batch is in the table; names are compared as the scans were sent.');
  const titles = [...new Set(seen.map(({ title }) => title))].sort();
  byId('sums').replaceChildren(...titles.map((title) => sumRow(title, seen.filter((pair) => pair.title === title))),
    ...(titles.length > 1 ? [sumRow('All', seen)] : []));
  byId('rows').replaceChildren(...pairs.map((pair) => make('tr', {},
    make('th', { scope: 'row', className: 'file' }, make('a', { href: `/jobs/${pair.job.id}`, textContent: pair.job.name })),
    make('td', { data: { name: 'Measurement' }, textContent: pair.title }),
    cell('Flat, cm', pair.observable ? cm(pair.value) : `(${cm(pair.value)})`), cell('Truth, cm', cm(pair.truth)),
    cell('Error, cm', signedCm(pair.error)))));
  const scans = new Set(pairs.map(({ job }) => job.id)).size;
  return `${scans} of ${newest.size} scans are in the table. What a scan hides is in no sum.`;
};

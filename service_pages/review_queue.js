// Results without a verdict, as cards that the review page's own script goes through.
import { get } from './api.js';
import { checkLine, checkLines } from './checks_list.js';
import { byId, cm, make, tellProblem } from './dom.js';
import { checksOf, labelPictures, resultOf } from './results.js';

const kPage = 48;

// Of several garments each has its name above its sizes.
const titleRow = ({ garments }, { title }) => (garments.length < 2 ? [] : [make('tr', { className: 'of' },
  make('th', { scope: 'rowgroup', colSpan: 3, textContent: title }))]);

const sizes = (result) => make('table', { className: 'sizes' },
  make('thead', {}, make('tr', {}, ...['cm', 'Flat', '90\u00a0%'].map((text, i) =>
    make('th', { scope: 'col', className: i > 0 ? 'n' : '', textContent: text })))),
  ...result.garments.map((garment) => make('tbody', {}, ...titleRow(result, garment), ...garment.measurements.map((m) => make('tr', {},
    make('th', { scope: 'row', textContent: m.title }),
    make('td', { className: 'n', textContent: m.observable ? cm(m.value_cm) : `(${cm(m.value_cm)})` }),
    make('td', { className: 'n none', textContent: `${cm(m.interval_cm[0])} – ${cm(m.interval_cm[1])}` }))))));

const card = (job, full, result, checks) => {
  const name = `${job.name || 'scan'} · ${job.id.slice(0, 6)}`;
  const good = checks.checks.filter(({ level }) => level === 'good').length;
  const pictures = labelPictures(job.id, full.files);
  const rest = good > 0 ? [checkLine('good', good === 1 ? '1 check is good' : `${good} checks are good`)] : [];
  const { warnings } = checks;
  if (warnings.length > 0) rest.push(make('li', { textContent: warnings.length === 1 ? '1 remark' : `${warnings.length} remarks` }));
  for (const line of rest) line.className = 'rest';
  return make('article', {
    className: `item ${checks.level}`, id: `result-${job.id}`, tabIndex: -1,
    data: { name, scan: job.name, scanSha256: result.scan.sha256, result: job.id, job: job.id },
  },
  make('header', {}, make('h2', {}, make('a', { href: `/jobs/${job.id}`, textContent: name })),
    make('p', { className: 'subject', textContent: result.garments.map(({ title }) => title).join(' over ') })),
  pictures.length > 0 ? make('div', { className: 'views' }, ...pictures) : make('p', { className: 'none no-picture', textContent: 'no picture of the labels' }),
  make('ul', { className: 'lights' }, ...checkLines(checks.checks), ...rest),
  ...(warnings.length > 0 ? [make('ul', { className: 'remarks' }, ...warnings.map((text) => make('li', { textContent: text })))] : []),
  sizes(result));
};

const cardOf = async (job) => {
  const [full, result, checks] = await Promise.all([get(`/v1/jobs/${job.id}`), resultOf(job.id), checksOf(job.id)]);
  return card(job, full, result, checks);
};

const run = (name) => new Promise((done, fail) => {
  const script = make('script', { src: `/pages/${name}`, onload: done, onerror: () => fail(new Error(`${name} could not be loaded`)) });
  document.head.append(script);
});

const begin = async () => {
  const query = new URLSearchParams(location.search);
  const asked = new URLSearchParams({ state: 'succeeded', reviewed: 'false', limit: String(kPage) });
  for (const name of ['after', 'batch', 'text']) if (query.has(name)) asked.set(name, query.get(name));
  const { jobs, next } = await get(`/v1/jobs?${asked}`);
  const fits = jobs.filter(({ kind }) => kind === 'fit' || kind === 'refit');
  // What was deleted meanwhile is left out.
  const cards = (await Promise.allSettled(fits.map(cardOf))).flatMap(({ value }) => (value ? [value] : []));
  byId('sheet').replaceChildren(...cards);
  byId('next').hidden = !next;
  byId('next').addEventListener('click', () => {
    query.set('after', next);
    location.search = query;
  });
  byId('waiting').hidden = cards.length > 0;
  byId('waiting').textContent = 'No result waits for a verdict.';
  if (cards.length === 0) return;
  for (const script of ['review_verdicts.js', 'posted_verdicts.js', 'review.js']) await run(script);
  byId('kept').textContent = 'Verdicts go to the service at once; undo takes them back there.';
};

begin().catch(tellProblem);

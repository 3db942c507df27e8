// An older result and a newer one side by side, and the verdict on the newer.
import { get, jobAddress, post, takeBack } from './api.js';
import { byId, cm, make, signedCm, tellProblem } from './dom.js';
import { labelPictures } from './results.js';

const rows = (before, now) => now.garments.flatMap((garment, g) => garment.measurements.map((m, i) => {
  const old = before.garments[g]?.measurements[i];
  const cell = (name, text) => make('td', { className: 'n', data: { name }, textContent: text });
  return make('tr', {},
    make('th', { scope: 'row', textContent: now.garments.length > 1 ? `${garment.title}: ${m.title}` : m.title },
      ...(m.fixed ? [make('span', { className: 'note', textContent: 'given, held' })] : [])),
    cell('Before', cm(old?.value_cm)),
    cell('Now', cm(m.value_cm)),
    cell('90 %', `${cm(m.interval_cm[0])} – ${cm(m.interval_cm[1])}`),
    cell('Change', signedCm(m.value_cm - old?.value_cm)));
}));

const edgeRows = (before, now) => now.garments.flatMap((garment, g) => garment.edges.map((edge) => {
  const old = before.garments[g]?.edges.find(({ name }) => name === edge.name);
  const cell = (name, text) => make('td', { className: 'n', data: { name }, textContent: text });
  return make('tr', { className: 'edge' },
    make('th', { scope: 'row', textContent: `height of the ${edge.name.replaceAll('_', ' ')}` }),
    cell('Before', cm(old?.height_cm)), cell('Now', cm(edge.height_cm)), cell('90 %', ''),
    cell('Change', signedCm(edge.height_cm - old?.height_cm)));
}));

const side = (title, job) => make('figure', {}, make('figcaption', {}, make('a', { href: `/jobs/${job.id}`, textContent: title })),
  make('div', { className: 'glance' }, ...labelPictures(job.id, job.files)));

let newest = '';
const showState = (job) => {
  byId('new-state').className = `state ${job.review?.verdict ?? 'open'}`;
  byId('new-state').textContent = job.review ? job.review.verdict : 'no verdict yet';
  for (const button of byId('decide').querySelectorAll('[data-verdict]')) {
    button.setAttribute('aria-pressed', String(button.dataset.verdict === job.review?.verdict));
  }
};

export const showComparison = async (source, before, id, now) => {
  const [old, job] = await Promise.all([source, id].map((one) => get(jobAddress(one))));
  newest = id;
  byId('compare').hidden = false;
  byId('both').replaceChildren(side('Before', old), side('Now', job));
  byId('changes').replaceChildren(...rows(before, now), ...edgeRows(before, now));
  byId('kept-verdict').textContent = old.review
    ? `The verdict on the one before stays: ${old.review.verdict}${old.review.note ? `, “${old.review.note}”` : ''}.`
    : 'The one before has no verdict and stays as it is.';
  showState(job);
};

for (const button of byId('decide').querySelectorAll('[data-verdict]')) {
  button.addEventListener('click', async () => {
    try {
      const address = `${jobAddress(newest)}/review`;
      const given = button.getAttribute('aria-pressed') === 'true';
      showState(await (given ? takeBack(address) : post(address, { verdict: button.dataset.verdict, note: '' })));
      tellProblem();
    } catch (error) {
      tellProblem(error);
    }
  });
}

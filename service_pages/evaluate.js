// Sets of scans against their truth: evaluated by the service, or finished jobs compared here.
import { get, send } from './api.js';
import { compareJobs } from './batch_comparison.js';
import { byId, make, since, tellProblem } from './dom.js';

const form = byId('set');
form.addEventListener('submit', async (event) => {
  event.preventDefault();
  const body = new FormData();
  body.append('table', byId('table').files[0]);
  const scans = byId('scans').files;
  body.append('name', byId('set-name').value.trim() || `Evaluation of ${scans.length === 1 ? scans[0].name : `${scans.length} scans`}`);
  [...scans].forEach((file, i) => body.append(`scan-${i + 1}`, file, file.name));
  const button = form.querySelector('button.main');
  button.disabled = true;
  byId('sent').hidden = false;
  byId('sending').textContent = 'Sending …';
  try {
    const job = await send('/v1/evaluations', body, (share) => { byId('sent').value = share; });
    location.assign(`/jobs/${job.id}`);
  } catch (error) {
    byId('sending').textContent = error.message;
  } finally {
    button.disabled = false;
    byId('sent').hidden = true;
  }
});

byId('compare').addEventListener('submit', async (event) => {
  event.preventDefault();
  byId('comparing').textContent = 'Reading the results …';
  try {
    byId('comparing').textContent = await compareJobs(byId('batch').value, await byId('truth').files[0].text());
  } catch (error) {
    byId('comparing').textContent = error.message;
  }
});

byId('make-page').addEventListener('click', async () => {
  const body = new FormData();
  const truth = byId('truth').files[0];
  if (truth) body.append('ground_truth', truth);
  byId('comparing').textContent = 'Asking for the page …';
  try {
    const job = await send(`/v1/batches/${encodeURIComponent(byId('batch').value)}/evaluation`, body, () => {});
    location.assign(`/jobs/${job.id}`);
  } catch (error) {
    byId('comparing').textContent = error.message;
  }
});

const begin = async () => {
  const [{ jobs }, { batches }] = await Promise.all([get('/v1/jobs?kind=evaluate&limit=50'), get('/v1/batches')]);
  byId('sets').replaceChildren(...jobs.map((job) => make('li', {},
    make('a', { href: `/jobs/${job.id}`, textContent: job.name || job.id }),
    make('span', { className: 'note', textContent: `${job.state}, ${since(job.created)}` }))));
  byId('no-sets').hidden = jobs.length > 0;
  const count = ({ jobs: states }) => Object.values(states).reduce((sum, n) => sum + n, 0);
  byId('batch').replaceChildren(...batches.map((batch) => make('option', {
    value: batch.id, textContent: `${batch.name} (${batch.jobs.succeeded} of ${count(batch)} succeeded, ${since(batch.created)})`,
  })));
  for (const button of byId('compare').querySelectorAll('button')) button.disabled = batches.length === 0;
  if (batches.length === 0) byId('batch').append(make('option', { value: '', textContent: 'no batch yet: send several scans at once' }));
};

begin().catch(tellProblem);

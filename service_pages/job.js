// One job: how far it is, what it found, and what can be done with it.
import { follow, get, isOpen, jobAddress, post, request, takeBack } from './api.js';
import { byId, bytes, make, tellProblem, words } from './dom.js';
import { clearStages, showProgress } from './job_progress.js';
import { showResult } from './job_result.js';
import { kRefitFields, optionFields } from './options_form.js';

const id = location.pathname.split('/')[2] ?? '';
let job;
let stop;

const kTitles = {
  queued: 'Waiting for a worker', running: 'Being measured', succeeded: 'Done', failed: 'This scan could not be measured',
  cancelled: 'Cancelled', dead: 'Given up after every attempt',
};

const optionWords = (options) => Object.entries(options ?? {})
  .map(([name, value]) => `${name} ${typeof value === 'object' ? JSON.stringify(value) : value}`).join(', ') || 'none';

const isFit = () => ['fit', 'refit'].includes(job.kind);
const when = (time) => (time ? new Date(time).toLocaleString('en', { dateStyle: 'medium', timeStyle: 'medium' }) : '–');

const showFacts = () => {
  const link = (address, text) => make('a', { href: address, textContent: text });
  const facts = [['Sent', when(job.created)], ['Begun', when(job.started)], ['Ended', when(job.ended)], ['Attempts', String(job.attempts)],
    ['Kind', job.kind], ['Garments', job.garments.join(' over ') || '–'], ['Options', optionWords(job.options)], ['Takes up', bytes(job.bytes)],
    ['Job', job.id]];
  if (job.source) facts.push(['Begins from', link(`/jobs/${job.source}`, job.source)]);
  if (job.batch) facts.push(['Batch', job.batch]);
  byId('facts').replaceChildren(...facts.map(([name, value]) =>
    make('div', {}, make('dt', { textContent: name }), make('dd', {}, value))));
};

const showReview = () => {
  byId('review-box').hidden = job.state !== 'succeeded' || !isFit();
  const verdict = job.review?.verdict;
  byId('review-state').className = `state ${verdict ?? 'open'}`;
  byId('review-state').textContent = verdict ?? 'none yet';
  byId('review-note').hidden = !job.review?.note;
  byId('review-note').textContent = job.review?.note ?? '';
  for (const button of byId('review-box').querySelectorAll('[data-verdict]')) {
    button.setAttribute('aria-pressed', String(button.dataset.verdict === verdict));
  }
};

const show = (now) => {
  job = now;
  const title = job.name || job.id;
  document.title = `${title} · Regarment`;
  byId('title').textContent = title;
  byId('subject').textContent = job.garments.join(' over ') || words(job.kind);
  byId('state-title').textContent = job.state === 'running' && job.cancel_wanted ? 'Being cancelled' : kTitles[job.state];
  byId('state-box').className = `verdict state-box ${{ failed: 'poor', dead: 'poor', cancelled: 'look' }[job.state] ?? ''}`;
  byId('state-words').textContent = job.error ? job.error.message : '';
  byId('progress-box').hidden = !isOpen(job);
  byId('cancel').hidden = !isOpen(job) || job.cancel_wanted;
  byId('requeue').hidden = !['failed', 'cancelled', 'dead'].includes(job.state);
  byId('delete').hidden = false;
  byId('again').hidden = job.state !== 'succeeded' || !isFit();
  byId('correct').href = `/jobs/${job.id}/correct`;
  showFacts();
  showReview();
};

const load = async () => {
  show(await get(jobAddress(id)));
  if (!isOpen(job)) stop?.();
  if (job.state === 'succeeded') await showResult(job);
};

const watch = () => {
  stop?.();
  clearStages();
  stop = follow(id, (kind, data) => {
    if (kind === 'progress') showProgress(data);
    else if (kind === 'deleted') tellProblem({ message: 'This job was deleted.' });
    else load().catch(tellProblem);
  });
};

const doing = (act) => async (event) => {
  event?.preventDefault();
  try {
    await act(event);
    tellProblem();
  } catch (error) {
    tellProblem(error);
  }
};

const begin = doing(async () => {
  await load();
  if (isOpen(job)) watch();
});

byId('cancel').addEventListener('click', doing(async () => {
  await post(`${jobAddress(id)}/cancel`);
  await load();
}));
byId('requeue').addEventListener('click', doing(async () => {
  await post(`${jobAddress(id)}/requeue`);
  await begin();
}));
byId('delete').addEventListener('click', () => {
  byId('sure').hidden = false;
  byId('delete-not').focus();
});
byId('delete-not').addEventListener('click', () => {
  byId('sure').hidden = true;
  byId('delete').focus();
});
byId('delete-sure').addEventListener('click', doing(async () => {
  stop?.();
  await request(jobAddress(id), { method: 'DELETE' });
  location.assign('/');
}));
for (const button of byId('review-box').querySelectorAll('[data-verdict]')) {
  button.addEventListener('click', doing(async () => {
    const [address, { verdict }] = [`${jobAddress(id)}/review`, button.dataset];
    const note = byId('note').value.trim();
    // The same verdict once more, with nothing new to say, takes it back.
    if (verdict === job.review?.verdict && note === '') show(await takeBack(address));
    else show(await post(address, { verdict, note: note || (job.review?.note ?? '') }));
    byId('note').value = '';
  }));
}
const options = optionFields(byId('again-options'), kRefitFields);
byId('again-form').addEventListener('submit', doing(async () => {
  const next = await post(`${jobAddress(id)}/refit`, { options: options() });
  location.assign(`/jobs/${next.id}`);
}));
begin();

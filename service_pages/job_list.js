// The jobs, newest first: found, paged, and kept up to date while the page is seen.
import { get, isOpen } from './api.js';
import { byId, make, since, tellProblem, words } from './dom.js';

const kPage = 15;
const kSoon = 1500;    // ms between two looks while something runs
const kLater = 10000;  // and when nothing does
const kMarks = { succeeded: '✓', failed: '✗', dead: '✗', cancelled: '–', queued: '…', running: '▸' };

let after = [''];  // where the pages begin that were seen, this one last
let [timer, asked] = [0, 0];

const address = () => {
  const query = new URLSearchParams(byId('reviewed').value);
  query.set('limit', String(kPage));
  for (const name of ['text', 'state']) if (byId(name).value) query.set(name, byId(name).value);
  if (after.at(-1)) query.set('after', after.at(-1));
  return `/v1/jobs?${query}`;
};

const stateCell = (job) => {
  const cell = make('td', { className: `job-state ${job.state}`, data: { name: 'State' } }, `${kMarks[job.state] ?? ''} ${job.state}`);
  if (job.state === 'running') {
    cell.append(make('progress', { max: 1, value: job.progress, ariaLabel: `Progress of ${job.name}` }),
      make('span', { className: 'note', textContent: job.stage ?? '' }));
  }
  if (job.error) cell.append(make('span', { className: 'note', textContent: job.error.message }));
  return cell;
};

const rowOf = (job) => make('tr', { data: { id: job.id } },
  make('th', { scope: 'row', className: 'file' },
    make('a', { href: `/jobs/${job.id}`, textContent: job.name || job.id }),
    make('span', { className: 'note', textContent: job.garments.length > 0 ? job.garments.join(' over ') : words(job.kind) })),
  stateCell(job),
  make('td', { data: { name: 'Verdict' }, className: `state ${job.review?.verdict ?? 'open'}`, textContent: job.review?.verdict ?? '–' }),
  make('td', { className: 'n', data: { name: 'Sent' }, textContent: since(job.created), title: job.created }));

// Rows that say the same stay as they are, so that focus and selection do.
const put = (jobs) => {
  const body = byId('jobs');
  const old = new Map([...body.children].map((row) => [row.dataset.id, row]));
  const rows = jobs.map((job) => {
    const row = rowOf(job);
    const same = old.get(job.id);
    return same?.isEqualNode(row) ? same : row;
  });
  if (rows.length !== body.children.length || rows.some((row, i) => row !== body.children[i])) {
    const focused = document.activeElement?.closest?.('#jobs tr')?.dataset.id;
    body.replaceChildren(...rows);
    if (focused) body.querySelector(`[data-id="${focused}"] a`)?.focus();
  }
};

export const refresh = async () => {
  clearTimeout(timer);
  asked += 1;
  const mine = asked;
  let wait = kLater;
  try {
    const { jobs, next } = await get(address());
    if (mine !== asked) return;
    put(jobs);
    byId('no-jobs').hidden = jobs.length > 0;
    byId('newer').disabled = after.length < 2;
    byId('older').disabled = !next;
    byId('older').dataset.next = next ?? '';
    if (jobs.some(isOpen)) wait = kSoon;
    tellProblem();
  } catch (error) {
    if (mine !== asked) return;
    tellProblem(error);
  }
  if (!document.hidden) timer = setTimeout(refresh, wait);
};

const again = () => {
  after = [''];
  refresh();
};

for (const name of ['text', 'state', 'reviewed']) byId(name).addEventListener('input', again);
byId('older').addEventListener('click', () => {
  after.push(byId('older').dataset.next);
  refresh();
});
byId('newer').addEventListener('click', () => {
  after.pop();
  refresh();
});
document.addEventListener('visibilitychange', refresh);

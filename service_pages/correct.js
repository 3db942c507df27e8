// A result corrected by hand: edges dragged on the picture, sizes that are known, fitted again from
// the prepared scan, and the new beside the old.
import { fileAddress, follow, get, isOpen, jobAddress, post } from './api.js';
import { showComparison } from './compare_results.js';
import { byId, make, tellProblem, words } from './dom.js';
import { edgeLine } from './edge_line.js';
import { drawFront } from './front_view.js';
import { resultOf } from './results.js';

let id = location.pathname.split('/')[2] ?? '';
let result;
let changes = { hint: {}, fix: {} };

const tell = () => {
  const count = Object.keys(changes.hint).length + Object.keys(changes.fix).length;
  byId('fit').disabled = byId('reset').disabled = count === 0;
  const one = ([name, value]) => `${words(name)} ${value.toFixed(1)} cm`;
  byId('fit-words').textContent = count === 0 ? 'Nothing is changed yet.'
    : [...Object.entries(changes.hint), ...Object.entries(changes.fix)].map(one).join(', ');
};

const note = (kind, name, value, was) => {
  const number = Number(value);
  if (String(value).trim() === '' || !(number > 0) || (was !== undefined && number.toFixed(1) === was.toFixed(1))) delete changes[kind][name];
  else changes[kind][name] = number;
  tell();
};

const numberField = (label, value, placeholder, limits) => {
  const input = make('input', { type: 'number', step: '0.1', value, placeholder, ...limits });
  return [make('label', { className: 'field' }, label, input), input];
};

// `limb`: what the edge lies round; a cuff's line crosses its own side of the picture alone.
const showEdge = (frame, garment, edge, limb) => {
  const name = `${garment.template}.${edge.name}_edge`;
  const title = `${words(edge.name)}${result.garments.length > 1 ? `, ${garment.title}` : ''}`;
  const [field, input] = numberField(title, edge.height_cm.toFixed(1), '', { min: '1', max: '299' });
  const line = edgeLine(byId('front'), frame, title, (value) => {
    input.value = value.toFixed(1);
    note('hint', name, value, edge.height_cm);
  });
  if (limb !== 'torso') line.element.classList.add(limb);
  line.put(edge.height_cm);
  input.addEventListener('input', () => {
    if (Number(input.value) > 0) line.put(Number(input.value));
    note('hint', name, input.value, edge.height_cm);
  });
  const settle = (height) => {
    input.value = height.toFixed(1);
    input.dispatchEvent(new Event('input'));
  };
  // Where else it may lie, as the fit weighed it.
  const others = edge.rivals.map(({ height_cm: height, weight }) => make('button', {
    type: 'button', textContent: `or ${height.toFixed(1)} (${Math.round(100 * weight)} %)`, onclick: () => settle(height),
  }));
  byId('edges').append(make('div', {}, field, ...(others.length > 0 ? [make('div', { className: 'rivals' }, ...others)] : [])));
};

const showSize = (garment, m) => {
  const title = `${m.title}${result.garments.length > 1 ? `, ${garment.title}` : ''}`;
  const [field, input] = numberField(title, m.fixed ? m.value_cm.toFixed(1) : '', `found ${m.value_cm.toFixed(1)}`, { min: '1', max: '999' });
  input.addEventListener('input', () => note('fix', `${garment.template}.${m.name}`, input.value, m.fixed ? m.value_cm : undefined));
  byId('sizes').append(field);
};

// Lines, fields and picture for the result that is now the newest.
const show = async () => {
  const [view, garments] = await Promise.all([get(fileAddress(id, 'pictures/view.json')), get('/pages/garments.json')]);
  for (const line of byId('front').querySelectorAll('.edge-line')) line.remove();
  byId('edges').replaceChildren();
  byId('sizes').replaceChildren();
  const frame = drawFront(byId('front-canvas'), view);
  for (const garment of result.garments) {
    // A neckline has no single height that could be given.
    const limbs = new Map(garments.find(({ name }) => name === garment.template)?.edges.map(({ name, limb }) => [name, limb]));
    for (const edge of garment.edges) if (limbs.has(edge.name)) showEdge(frame, garment, edge, limbs.get(edge.name));
    for (const m of garment.measurements) showSize(garment, m);
  }
  changes = { hint: {}, fix: {} };
  tell();
};

const finished = (job) => new Promise((done, fail) => {
  const bar = byId('fit-progress');
  bar.value = 0;
  const stop = follow(job, async (kind, data) => {
    if (kind === 'progress') {
      bar.value = data.progress;
      byId('fit-words').textContent = `Fitting again: ${data.stage} …`;
      return;
    }
    try {
      const now = await get(jobAddress(job));
      if (isOpen(now)) return;
      stop();
      done(now);
    } catch (error) {
      stop();
      fail(error);
    }
  });
});

const fitAgain = async () => {
  byId('fit').disabled = byId('reset').disabled = true;
  byId('fit-progress').hidden = false;
  byId('fit-words').textContent = 'Waiting for a worker …';
  const options = Object.fromEntries(Object.entries(changes).filter(([, named]) => Object.keys(named).length > 0));
  const asked = await post(`${jobAddress(id)}/refit`, { options });
  const job = await finished(asked.id);
  byId('fit-progress').hidden = true;
  if (job.state !== 'succeeded') {
    tell();
    throw new Error(job.error?.message ?? `The fit was ${job.state}.`);
  }
  const [before, source] = [result, id];
  id = job.id;
  result = await resultOf(id);
  history.replaceState(null, '', `/jobs/${id}/correct`);
  await show();
  await showComparison(source, before, id, result);
  byId('compare').scrollIntoView({ block: 'start' });
};

const doing = (act) => async (event) => {
  event?.preventDefault();
  try {
    await act();
    tellProblem();
  } catch (error) {
    byId('fit-progress').hidden = true;
    tellProblem(error);
  }
};

byId('known').addEventListener('submit', doing(fitAgain));
byId('reset').addEventListener('click', doing(show));
doing(async () => {
  const job = await get(jobAddress(id));
  const title = job.name || id;
  document.title = `Correct ${title} · Regarment`;
  byId('title').textContent = title;
  byId('subject').replaceChildren(make('a', { href: `/jobs/${id}`, textContent: 'back to the job' }));
  if (job.state !== 'succeeded') throw new Error(`This job is ${job.state}; only a result can be corrected.`);
  result = await resultOf(id);
  await show();
  if (job.source) await showComparison(job.source, await resultOf(job.source), id, result).catch(() => {});
})();

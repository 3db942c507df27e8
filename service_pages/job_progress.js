// The stages of a running job.
import { addToCurve } from './error_curve.js';
import { byId, make } from './dom.js';

const kWords = {
  read: 'read the scan', prepare: 'prepare it', place: 'place the garments', measure: 'measure', fit: 'fit', fill: 'close holes',
  draw: 'draw', write: 'write', evaluate: 'evaluate',
};

export const clearStages = () => {
  byId('stages').replaceChildren();
  byId('progress').value = 0;
};

export const showProgress = ({ progress, stage, detail, error }) => {
  byId('progress').value = Math.max(byId('progress').value, progress ?? 0);
  addToCurve({ detail, error });
  if (!stage) return;
  const list = byId('stages');
  let line = [...list.children].find((one) => one.dataset.stage === stage);
  if (!line) {
    for (const one of list.children) one.className = 'done';
    line = make('li', { data: { stage } }, make('span', { textContent: kWords[stage] ?? stage }), make('span', { className: 'note' }));
    list.append(line);
  }
  for (const one of list.children) one.className = one === line ? 'now' : 'done';
  line.querySelector('.note').textContent = detail ?? '';
};

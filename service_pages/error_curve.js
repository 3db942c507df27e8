// How the error of a search goes down, drawn from the words of its progress.
import { byId, drawn } from './dom.js';

const [kLeft, kRight, kTop, kBottom] = [52, 632, 10, 156];
const kMost = 2000;  // points kept
const seen = [];

const errorIn = ({ error, detail }) => {
  if (Number.isFinite(error)) return error;
  const found = /\berror ([0-9.]+(?:e[-+]?\d+)?)/i.exec(detail ?? '');
  return found ? Number(found[1]) : NaN;
};

const tick = (value, y) => drawn('text', { x: kLeft - 8, y: y + 4, class: 'y' }, value.toPrecision(3));

// Takes the data of a progress event; shows the curve from the second value on.
export const addToCurve = (data) => {
  const error = errorIn(data);
  if (!(error > 0)) return;
  if (seen.length === kMost) seen.shift();
  seen.push(error);
  if (seen.length < 2) return;
  const [low, high] = [Math.min(...seen), Math.max(...seen)];
  const across = (i) => kLeft + (kRight - kLeft) * i / (seen.length - 1);
  const up = (value) => kBottom - (kBottom - kTop) * (high > low ? (value - low) / (high - low) : 0.5);
  byId('error-curve').hidden = false;
  byId('curve').setAttribute('d', seen.map((value, i) => `${i === 0 ? 'M' : 'L'}${across(i).toFixed(1)} ${up(value).toFixed(1)}`).join(''));
  byId('curve-axis').replaceChildren(
    drawn('path', { d: `M${kLeft} ${kTop}V${kBottom}H${kRight}`, class: 'ends' }),
    ...(high > low ? [tick(high, kTop), tick(low, kBottom)] : [tick(low, up(low))]));
  byId('curve-words').textContent = `Error of the search, ${seen.length} times told: now ${seen.at(-1).toPrecision(3)}, best ${low.toPrecision(3)}`;
};

// A line across the picture that stands for an edge: dragged, or moved with the arrow keys.
import { make } from './dom.js';

const kStep = 0.1;  // cm
const kFar = 1;

// `frame` of front_view.js; `moved(cm)` after each move. Returns {element, put(cm)}.
export const edgeLine = (box, frame, name, moved) => {
  const grip = make('span', { className: 'edge-name', textContent: name });
  const element = make('div', { className: 'edge-line', tabIndex: 0 }, grip);
  element.setAttribute('role', 'slider');
  const say = (key, value) => element.setAttribute(`aria-${key}`, value);
  say('label', `Height of the ${name}, cm`);
  say('orientation', 'vertical');
  const limits = [frame.metres(frame.height), frame.metres(0)].map((m) => Math.max(0, m * 100));
  say('valuemin', limits[0].toFixed(0));
  say('valuemax', limits[1].toFixed(0));
  let at = 0;

  const put = (value) => {
    at = Math.min(Math.max(value, limits[0]), limits[1]);
    element.style.top = `${100 * frame.row(at / 100) / frame.height}%`;
    say('valuenow', at.toFixed(1));
  };
  const move = (value) => {
    put(value);
    moved(Math.round(at * 10) / 10);
  };
  element.addEventListener('keydown', (event) => {
    const by = { ArrowUp: 1, ArrowDown: -1, ArrowRight: 1, ArrowLeft: -1, PageUp: 10, PageDown: -10 }[event.key];
    if (!by) return;
    event.preventDefault();
    move(at + by * (event.shiftKey ? kFar : kStep));
  });
  element.addEventListener('pointerdown', (event) => {
    event.preventDefault();
    element.setPointerCapture(event.pointerId);
    element.focus();
    const drag = (now) => {
      const { top, height } = box.getBoundingClientRect();
      move(100 * frame.metres((now.clientY - top) / height * frame.height));
    };
    const end = () => element.removeEventListener('pointermove', drag);
    element.addEventListener('pointermove', drag);
    element.addEventListener('pointerup', end, { once: true });
    element.addEventListener('pointercancel', end, { once: true });
  });
  box.append(element);
  return { element, put };
};

// Garments chosen by their sketch, in the order they are chosen: the outermost first.
import { get } from './api.js';
import { byId, make } from './dom.js';

export const garmentCards = async (changed) => {
  const garments = await get('/pages/garments.json');
  let chosen = [];
  const boxes = new Map();

  const show = () => {
    for (const { name } of garments) {
      const { input, number } = boxes.get(name);
      const at = chosen.indexOf(name);
      input.checked = at >= 0;
      number.textContent = at >= 0 && chosen.length > 1 ? String(at + 1) : '';
    }
    const titles = chosen.map((name) => garments.find((one) => one.name === name).title);
    byId('garments-words').textContent = titles.length > 0 ? titles.join(' over ') : 'Choose at least one garment.';
    changed();
  };

  byId('garments').replaceChildren(...garments.map(({ name, title, sketch }) => {
    const input = make('input', { type: 'checkbox', value: name });
    const number = make('span', { className: 'order' });
    boxes.set(name, { input, number });
    input.addEventListener('change', () => {
      chosen = chosen.filter((one) => one !== name);
      if (input.checked) chosen.push(name);
      show();
    });
    return make('label', { className: 'garment-card' }, input,
      make('img', { src: sketch, alt: '', width: 120, height: 120 }), make('span', { textContent: title }), number);
  }));
  show();
  return () => chosen;
};

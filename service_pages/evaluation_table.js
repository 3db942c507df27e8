// The figures of an evaluation: all dimensions together, then one by one.
import { cm, make, signedCm } from './dom.js';

const share = (value) => (Number.isFinite(value) ? `${Math.round(100 * value)} %` : '–');
const kColumns = [
  ['Values', ({ n }) => String(n)], ['Bias, cm', ({ bias_cm: value }) => signedCm(value ?? NaN)],
  ['Mean |error|, cm', ({ mae_cm: value }) => cm(value)], ['95 % below, cm', ({ p95_cm: value }) => cm(value)],
  ['Worst, cm', ({ worst_cm: value }) => cm(value)], ['In its 90 %', ({ coverage }) => share(coverage)],
];

export const evaluationTable = ({ statistics }) => {
  const shown = statistics.filter(({ by, values }) => (by === 'all' || by === 'measurement') && values.n > 0);
  const section = make('section', {},
    make('h2', { id: 'figures', textContent: 'Figures' }),
    make('table', { className: 'plain measures' },
      make('thead', {}, make('tr', {}, make('th', { scope: 'col', textContent: 'Dimensions' }),
        ...kColumns.map(([name]) => make('th', { scope: 'col', className: 'n', textContent: name })))),
      make('tbody', {}, ...shown.map(({ name, values }) => make('tr', {}, make('th', { scope: 'row', textContent: name }),
        ...kColumns.map(([title, text]) => make('td', { className: 'n', data: { name: title }, textContent: text(values) })))))));
  section.setAttribute('aria-labelledby', 'figures');
  return section;
};

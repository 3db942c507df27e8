// The measurements of a result as tables, beside those of an earlier one where it is given.
import { cm, make, signedCm } from './dom.js';

const numberCell = (name, text, properties = {}) => make('td', { className: 'n', data: { name }, ...properties }, text);

const sameIn = (result, garment, name) => result?.garments
  .find((one) => one.template === garment.template && one.layer === garment.layer)?.measurements
  .find((one) => one.name === name);

const rowOf = (m, before, { truth, earlier }) => {
  const value = make('b', { className: 'value', textContent: m.observable ? cm(m.value_cm) : `(${cm(m.value_cm)})` });
  const row = make('tr', {},
    make('td', { className: 'code', textContent: m.code }),
    make('th', { scope: 'row', textContent: m.title },
      ...(m.observable ? [] : [make('span', { className: 'how', textContent: 'not seen on the scan: a probable value' })]),
      ...(m.fixed ? [make('span', { className: 'tag', textContent: 'given, held' })] : [])),
    numberCell('Flat, cm', value),
    numberCell('90 %', `${cm(m.interval_cm[0])} – ${cm(m.interval_cm[1])}`),
    numberCell('Worn, cm', cm(m.worn_cm)));
  if (earlier) {
    row.append(numberCell('Before, cm', cm(before?.value_cm)), numberCell('Change, cm', signedCm(m.value_cm - before?.value_cm)));
  }
  if (truth) row.append(numberCell('Truth, cm', cm(m.truth_cm)), numberCell('Error, cm', signedCm(m.error_cm)));
  return row;
};

export const measurementTables = (result, before) => result.garments.map((garment) => {
  const shown = { truth: garment.measurements.some((m) => Number.isFinite(m.truth_cm)), earlier: Boolean(before) };
  const heads = ['Flat, cm', '90\u00a0%', 'Worn, cm', ...(shown.earlier ? ['Before, cm', 'Change, cm'] : []),
    ...(shown.truth ? ['Truth, cm', 'Error, cm'] : [])];
  const id = `garment-${garment.layer}`;
  const section = make('section', {},
    make('h2', { id, textContent: garment.title }),
    make('table', { className: 'plain measures' },
      make('thead', {}, make('tr', {}, make('th', { scope: 'col', textContent: 'Code' }), make('th', { scope: 'col', textContent: 'Measurement' }),
        ...heads.map((text) => make('th', { scope: 'col', className: 'n', textContent: text })))),
      make('tbody', {}, ...garment.measurements.map((m) => rowOf(m, sameIn(before, garment, m.name), shown)))));
  section.setAttribute('aria-labelledby', id);
  return section;
});

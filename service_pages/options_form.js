// Fields for the options of a fit, and what they say as the JSON of a job's options.
import { make } from './dom.js';

const axes = ['+x', '-x', '+y', '-y', '+z', '-z'];
const choice = (name, label, values, note) => ({ name, label, values, note });
const kFields = {
  method: choice('method', 'Method', [['', 'joint, the newest'], ['direct', 'direct: from the scan alone'], ['annealing', 'annealing: the paper, slow']]),
  fabric: choice('fabric', 'Fabric', [['', 'any'], ['woven'], ['jersey'], ['elastic']], 'how far worn cloth stretches'),
  units: choice('units', 'Unit of the file', [['', 'found by itself'], ['mm'], ['cm'], ['m'], ['inch']]),
  up: choice('up', 'Up', [['', 'found by itself'], ...axes.map((axis) => [axis])]),
  front: choice('front', 'Front', [['', 'found by itself'], ...axes.map((axis) => [axis])]),
  fix: { name: 'fix', label: 'Known sizes', place: 'skirt.length=54', note: 'cm, held exactly; several with commas' },
  hint: { name: 'hint', label: 'Edges seen', place: 'skirt.waist_edge=103', note: 'cm above the floor, looked for within 3 cm' },
  seed: { name: 'seed', label: 'Seed', number: true, place: '1' },
  runs: { name: 'runs', label: 'Runs', number: true, note: 'of the method annealing' },
  forget: { name: 'forget', label: 'Forget sizes and edges given before', box: true },
};
export const kFitFields = ['method', 'fabric', 'units', 'up', 'front', 'fix', 'hint', 'seed', 'runs'];
export const kRefitFields = ['method', 'fabric', 'fix', 'hint', 'forget'];

const control = (field) => {
  if (field.values) {
    return make('select', { name: field.name }, ...field.values.map(([value, text]) =>
      make('option', { value, textContent: text ?? value })));
  }
  if (field.box) return make('input', { type: 'checkbox', name: field.name });
  return make('input', {
    type: field.number ? 'number' : 'text', name: field.name, placeholder: field.place ?? '', autocomplete: 'off',
    ...(field.number ? { min: '0', step: '1' } : {}),
  });
};

// Puts the fields into `box`; returns what reads them.
export const optionFields = (box, names, changed = () => {}) => {
  const controls = names.map((name) => {
    const field = kFields[name];
    const input = control(field);
    input.addEventListener('input', changed);
    const label = make('label', { className: field.box ? 'field box' : 'field' }, field.label, input);
    if (field.note) label.append(make('span', { className: 'note', textContent: field.note }));
    box.append(label);
    return [name, input];
  });
  return () => Object.fromEntries(controls.flatMap(([name, input]) => {
    if (input.type === 'checkbox') return input.checked ? [[name, true]] : [];
    const value = input.value.trim();
    if (value === '') return [];
    return [[name, input.type === 'number' ? Number(value) : value]];
  }));
};

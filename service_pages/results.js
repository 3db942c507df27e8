// What the service keeps of a result, and its pictures.
import { fileAddress, get, jobAddress } from './api.js';
import { make } from './dom.js';

export const resultOf = (id) => get(fileAddress(id, 'result.json'));
export const checksOf = (id) => get(`${jobAddress(id)}/checks`);

export const labelPictures = (id, files, sides = ['front', 'back']) => sides
  .map((side) => [side, `pictures/segmentation-${side}.jpg`]).filter(([, file]) => files.includes(file))
  .map(([side, file]) => make('img', { src: fileAddress(id, file), alt: `Labels from the ${side}`, width: 420, height: 760, loading: 'lazy' }));

// The lights of a result's verdict, as the report has them.
import { make } from './dom.js';

const kSigns = { good: '✓', look: '!', poor: '✗' };

export const sign = (level) => make('span', { className: 'sign', textContent: kSigns[level], aria: { hidden: 'true' } });

export const checkLine = (level, text, advice) => make('li', { className: level },
  sign(level), make('span', { className: 'light', textContent: level }), ` ${text}`,
  ...(advice ? [make('span', { className: 'advice', textContent: ` ${advice}` })] : []));

export const checkLines = (checks) => checks.map(({ level, name, found, advice }) => checkLine(level, `${name}: ${found}`, advice));

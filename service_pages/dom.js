// What all pages build themselves with.
export const byId = (id) => document.getElementById(id);

// Text is always text: nothing here reads markup.
export const make = (kind, properties = {}, ...children) => {
  const { data = {}, aria = {}, ...rest } = properties;
  const element = Object.assign(document.createElement(kind), rest);
  Object.assign(element.dataset, data);
  for (const [name, value] of Object.entries(aria)) element.setAttribute(`aria-${name}`, value);
  element.append(...children);
  return element;
};

export const drawn = (kind, attributes, ...children) => {
  const element = document.createElementNS('http://www.w3.org/2000/svg', kind);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
};

export const cm = (value) => (Number.isFinite(value) ? value.toFixed(1).replace(/^-(?=0\.0$)/, '') : '–');
export const signedCm = (value) => {
  const text = cm(Math.abs(value));
  if (text === '0.0' || text === '–') return text;
  return (value < 0 ? '−' : '+') + text;
};

export const bytes = (count) => {
  if (count < 1e4) return `${count} B`;
  return count < 1e6 ? `${(count / 1e3).toFixed(0)} KB` : `${(count / 1e6).toFixed(1)} MB`;
};

const ago = new Intl.RelativeTimeFormat('en', { numeric: 'auto' });
export const since = (time) => {
  const seconds = (Date.parse(time) - Date.now()) / 1000;
  if (seconds > -60) return 'just now';
  if (seconds > -3600) return ago.format(Math.ceil(seconds / 60), 'minute');
  if (seconds > -86400) return ago.format(Math.ceil(seconds / 3600), 'hour');
  return new Date(time).toLocaleDateString('en', { dateStyle: 'medium' });
};

// "left_cuff": "left cuff"
export const words = (name) => name.replaceAll('_', ' ');

export const tellProblem = (error) => {
  const line = byId('problem');
  line.hidden = !error;
  line.textContent = error ? error.message : '';
};

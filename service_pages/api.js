// Requests to the service, with its words where it refuses, and its key where it wants one.
import { byId } from './dom.js';

export class Problem extends Error {
  constructor(status, code, detail) {
    super(detail);
    Object.assign(this, { status, code });
  }

  static from(status, text) {
    try {
      const { code, detail, title } = JSON.parse(text);
      return new Problem(status, code ?? '', detail || title || `the service answered ${status}`);
    } catch {
      return new Problem(status, '', `the service answered ${status}`);
    }
  }
}

let asking;
const askForKey = () => {
  asking ??= new Promise((done) => {
    const [dialog, form, field] = [byId('sign-in'), byId('sign-in-form'), byId('key')];
    const submit = async (event) => {
      event.preventDefault();
      const answer = await fetch('/v1/session', {
        method: 'POST', headers: { 'Content-Type': 'application/json' }, body: JSON.stringify({ key: field.value.trim() }),
      });
      if (!answer.ok) {
        byId('key-problem').textContent = Problem.from(answer.status, await answer.text()).message;
        return;
      }
      form.removeEventListener('submit', submit);
      field.value = '';
      dialog.close();
      asking = undefined;
      sessionStorage.setItem('signed-in', 'yes');
      showLeave();
      done();
    };
    form.addEventListener('submit', submit);
    dialog.addEventListener('cancel', (event) => event.preventDefault());
    dialog.showModal();
  });
  return asking;
};

const showLeave = () => { byId('leave').hidden = sessionStorage.getItem('signed-in') !== 'yes'; };
byId('leave').addEventListener('click', async () => {
  await fetch('/v1/session', { method: 'DELETE' });
  sessionStorage.removeItem('signed-in');
  location.assign('/');
});
showLeave();

const reach = async (path, options) => {
  try {
    return await fetch(path, options);
  } catch {
    throw new Problem(0, 'unreachable', 'the service cannot be reached; is it still running?');
  }
};

// The answer, once a key was given where one is needed. Throws Problem for all but 2xx.
export const request = async (path, options = {}) => {
  const answer = await reach(path, options);
  if (answer.status === 401) {
    await askForKey();
    return request(path, options);
  }
  if (!answer.ok) throw Problem.from(answer.status, await answer.text());
  return answer;
};

export const get = async (path) => (await request(path)).json();

export const post = async (path, body) => {
  const json = body === undefined ? {} : { headers: { 'Content-Type': 'application/json' }, body: JSON.stringify(body) };
  return (await request(path, { method: 'POST', ...json })).json();
};

export const takeBack = async (path) => (await request(path, { method: 'DELETE' })).json();

// A form with files: told how much of it was sent, from 0 to 1.
export const send = async (path, form, sent) => {
  const { status, text } = await new Promise((done, fail) => {
    const upload = new XMLHttpRequest();
    upload.open('POST', path);
    upload.upload.addEventListener('progress', (event) => {
      if (event.lengthComputable) sent(event.loaded / event.total);
    });
    upload.addEventListener('load', () => done({ status: upload.status, text: upload.responseText }));
    upload.addEventListener('error', () => fail(new Problem(0, 'unreachable', 'the upload broke off; is the service still running?')));
    upload.send(form);
  });
  if (status === 401) {
    await askForKey();
    return send(path, form, sent);
  }
  if (status < 200 || status > 299) throw Problem.from(status, text);
  return JSON.parse(text);
};

export const jobAddress = (id) => `/v1/jobs/${encodeURIComponent(id)}`;
export const fileAddress = (id, file) => `${jobAddress(id)}/${file.split('/').map(encodeURIComponent).join('/')}`;

const kOpen = ['queued', 'running'];
export const isOpen = (job) => kOpen.includes(job.state);

// Follows the events of a job from its first; `told(kind, data)` for each. Returns what stops it: a
// job that failed may have been queued again, so its state alone says whether it is over.
export const follow = (id, told) => {
  const source = new EventSource(`${jobAddress(id)}/events`);
  for (const kind of ['state', 'progress', 'review', 'deleted']) {
    source.addEventListener(kind, (event) => {
      if (kind === 'deleted') source.close();
      told(kind, JSON.parse(event.data));
    });
  }
  return () => source.close();
};

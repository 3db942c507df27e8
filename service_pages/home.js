// Scans are sent from here, one job each.
import { post, send } from './api.js';
import { byId, bytes, tellProblem } from './dom.js';
import { garmentCards } from './garment_cards.js';
import { refresh } from './job_list.js';
import { kFitFields, optionFields } from './options_form.js';
import { readPoints } from './ply_points.js';
import { drawPreview } from './scan_preview.js';

const [form, drop, input, sending, sent] = ['submit', 'drop', 'scan', 'sending', 'sent'].map(byId);
let chosenGarments = () => [];
let looked = {};  // the file that is looked at, and its points
let files = [];

const look = async () => {
  const [box, words] = [byId('preview'), byId('preview-words')];
  const file = files[0];
  box.hidden = !file;
  if (!file) return;
  if (looked.file !== file) {
    looked = { file };
    byId('preview-sides').replaceChildren();
    words.textContent = 'Looking at it …';
    const read = await readPoints(file).catch(() => undefined);
    if (looked.file !== file) return;
    looked.read = read;
  }
  if (!looked.read) {
    words.textContent = 'No preview of this format; the service reads it all the same.';
    return;
  }
  drawPreview(byId('preview-sides'), looked.read, options());
  words.textContent = `${looked.read.count.toLocaleString('en')} points. A quick look in this browser, turned as it seems; the service looks closer.`;
};

const options = optionFields(byId('options'), kFitFields, () => { look(); });

const [dropName, dropNote] = ['b', '.note'].map((part) => byId('drop-words').querySelector(part));
const [kName, kNote] = [dropName.textContent, dropNote.textContent];
const take = (list) => {
  files = [...list];
  drop.classList.toggle('full', files.length > 0);
  const size = bytes(files.reduce((sum, file) => sum + file.size, 0));
  dropName.textContent = { 0: kName, 1: files[0]?.name }[files.length] ?? `${files.length} scans`;
  dropNote.textContent = files.length > 0 ? `${size}; choose or drop another instead` : kNote;
  look();
};

input.addEventListener('change', () => take(input.files));
for (const kind of ['dragenter', 'dragover']) {
  drop.addEventListener(kind, (event) => {
    event.preventDefault();
    drop.classList.add('over');
  });
}
for (const kind of ['dragleave', 'drop']) drop.addEventListener(kind, () => drop.classList.remove('over'));
drop.addEventListener('drop', (event) => {
  event.preventDefault();
  take(event.dataTransfer.files);
});

const submit = async (file, batch) => {
  const body = new FormData();
  body.append('garments', JSON.stringify(chosenGarments()));
  body.append('options', JSON.stringify(options()));
  if (batch) body.append('batch', batch);
  const truth = byId('truth').files[0];
  if (truth) body.append('ground_truth', truth);
  body.append('scan', file, file.name);
  return send('/v1/jobs', body, (share) => { sent.value = share; });
};

form.addEventListener('submit', async (event) => {
  event.preventDefault();
  if (files.length === 0 || chosenGarments().length === 0) {
    sending.textContent = files.length === 0 ? 'Choose a scan first.' : 'Choose at least one garment first.';
    (files.length === 0 ? input : byId('garments').querySelector('input')).focus();
    return;
  }
  const button = form.querySelector('button.main');
  button.disabled = true;
  sent.hidden = false;
  try {
    const batch = files.length > 1 ? await post('/v1/batches', { name: `${files.length} scans, ${files[0].name} first` }) : undefined;
    let job;
    for (const [i, file] of files.entries()) {
      sent.value = 0;
      sending.textContent = files.length > 1 ? `Sending ${i + 1} of ${files.length} …` : 'Sending …';
      job = await submit(file, batch?.id);
    }
    if (files.length === 1) {
      location.assign(`/jobs/${job.id}`);
      return;
    }
    sending.textContent = `${files.length} scans are sent.`;
    input.value = '';
    take([]);
    tellProblem();
    refresh();
  } catch (error) {
    sending.textContent = error.message;
  } finally {
    button.disabled = false;
    sent.hidden = true;
  }
});

refresh();
garmentCards(() => { if (files.length > 0) sending.textContent = ''; })
  .then((chosen) => { chosenGarments = chosen; }, tellProblem);
if (input.files.length > 0) take(input.files);

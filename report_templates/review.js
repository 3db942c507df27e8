'use strict';
// The review page by keyboard: one result is current, keys and buttons decide about it.
{
  const byId = (id) => document.getElementById(id);
  const cards = [...document.querySelectorAll('.item')];
  const verdicts = new Verdicts(document.body.dataset.page, cards.map(({ dataset }) => ({
    result: dataset.name, scan: dataset.scan, scan_sha256: dataset.scanSha256, result_digest: dataset.result })));
  const [filter, which, tally] = [byId('filter'), byId('which'), byId('tally')];
  let current = cards[0];

  const make = (kind, properties, ...children) => {
    const element = Object.assign(document.createElement(kind), properties);
    element.append(...children);
    return element;
  };
  const stateOf = (card) => verdicts.of(card.dataset.name);
  const shown = () => cards.filter((card) => !card.hidden);

  const matches = (card) => {
    const { verdict, note } = stateOf(card);
    const kind = { all: true, open: !verdict, noted: Boolean(note), odd: !card.classList.contains('good') };
    if (!(kind[which.value] ?? verdict === which.value)) return false;
    const text = `${card.textContent} ${note}`.toLowerCase();
    return filter.value.toLowerCase().split(/\s+/).every((word) => text.includes(word));
  };

  const describe = ({ verdict, outdated }) => {
    if (verdict) return verdict === 'accepted' ? '✓ accepted' : '✗ rejected';
    return outdated ? `undecided; ${outdated} before the result changed` : 'undecided';
  };

  const paint = (card) => {
    const state = stateOf(card);
    card.classList.toggle('accepted', state.verdict === 'accepted');
    card.classList.toggle('rejected', state.verdict === 'rejected');
    const line = card.querySelector('.state');
    line.className = `state ${state.verdict || 'open'}`;
    line.textContent = describe(state);
    const note = card.querySelector('.written');
    note.hidden = !state.note;
    note.textContent = state.note;
    for (const button of card.querySelectorAll('[data-verdict]')) {
      button.setAttribute('aria-pressed', String(button.dataset.verdict === state.verdict));
    }
  };

  const tell = (news = '') => {
    const count = (word) => cards.filter((card) => stateOf(card).verdict === word).length;
    const [yes, no] = [count('accepted'), count('rejected')];
    const rest = verdicts.kept ? '' : ' This browser does not keep them: export before you close the page.';
    tally.textContent = `${news}${yes + no} of ${cards.length} decided: ${yes} accepted, ${no} rejected.`
      + `${shown().length < cards.length ? ` ${shown().length} shown.` : ''}${rest}`;
    byId('done').style.width = `${100 * (yes + no) / cards.length}%`;
    byId('undo').disabled = !verdicts.undoable;
  };

  const choose = (card, focus = true) => {
    if (!card) return;
    current?.removeAttribute('aria-current');
    current = card;
    card.setAttribute('aria-current', 'true');
    if (!focus) return;
    card.focus({ preventScroll: true });
    const room = innerHeight - byId('bar').offsetHeight;
    card.scrollIntoView({ block: card.offsetHeight < room ? 'nearest' : 'start' });
  };

  const sift = () => {
    for (const card of cards) card.hidden = !matches(card);
    byId('none-left').hidden = shown().length > 0;
    if (current?.hidden) choose(shown()[0] ?? current, false);
    tell();
  };

  const step = (by) => {
    const list = shown();
    const at = list.indexOf(current);
    choose(list[Math.min(Math.max(at + by, 0), list.length - 1)]);
  };

  // On to the next undecided result, from the top again at the end.
  const decide = (card, verdict) => {
    const list = shown();
    const after = [...list.slice(list.indexOf(card) + 1), ...list.slice(0, list.indexOf(card))];
    verdicts.set(card.dataset.name, { verdict: stateOf(card).verdict === verdict ? '' : verdict });
    paint(card);
    const open = after.find((other) => !stateOf(other).verdict);
    sift();
    if (stateOf(card).verdict) choose(open ?? (card.hidden ? current : card));
    tell(`${card.dataset.name} ${describe(stateOf(card)).replace(/^. /, '')}. `);
  };

  const undo = () => {
    const name = verdicts.undo();
    cards.forEach(paint);
    sift();
    const card = cards.find((one) => one.dataset.name === name);
    if (card && !card.hidden) choose(card);
  };

  const write = (card) => {
    if (card.querySelector('textarea')) return;
    choose(card);
    const box = make('textarea', { value: stateOf(card).note, maxLength: 2000 });
    box.setAttribute('aria-label', `Note on ${card.dataset.name}`);
    let asked = true;  // removing the box takes its focus, which asks again
    const close = (keep) => {
      if (!asked) return;
      asked = false;
      const note = box.value.trim();
      box.remove();
      if (keep && note !== stateOf(card).note) verdicts.set(card.dataset.name, { note });
      paint(card);
      sift();
      choose(card);
    };
    box.addEventListener('keydown', (event) => {
      if (event.key !== 'Escape' && (event.key !== 'Enter' || event.shiftKey)) return;
      event.preventDefault();
      close(event.key === 'Enter');
    });
    box.addEventListener('blur', () => close(true));
    card.querySelector('.decide').after(box);
    box.focus();
  };

  const save = (text, type, name) => {
    const link = make('a', { href: URL.createObjectURL(new Blob([text], { type })), download: name });
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  };

  const load = async (file) => {
    try {
      const { taken, unknown } = verdicts.read(await file.text());
      cards.forEach(paint);
      sift();
      tell(`${taken} verdicts taken from ${file.name}${unknown ? `, ${unknown} are about results that are not here` : ''}. `);
    } catch (error) {
      tell(`${file.name} cannot be imported (${error.message}); give a file this page exported. `);
    }
  };

  const closer = () => {
    const on = document.documentElement.classList.toggle('closer');
    byId('size').setAttribute('aria-pressed', String(on));
    choose(current);
  };

  const keys = {
    j: () => step(1), ArrowRight: () => step(1), ArrowDown: () => step(1),
    k: () => step(-1), ArrowLeft: () => step(-1), ArrowUp: () => step(-1),
    a: () => decide(current, 'accepted'), r: () => decide(current, 'rejected'),
    n: () => write(current), u: undo, z: closer,
    o: () => current.querySelector('h2 a')?.click(),
    '/': () => filter.focus(), '?': () => byId('keys').showModal(),
  };

  const dress = (card) => {
    const button = (text, verdict, act) => {
      const one = make('button', { type: 'button', textContent: text, onclick: act });
      one.setAttribute('aria-label', `${text.replace(/^. /, '')}: ${card.dataset.name}`);
      if (verdict) one.dataset.verdict = verdict;
      return one;
    };
    card.querySelector('.views, img, .no-picture').after(make('p', { className: 'state' }), make('p', { className: 'written' }),
      make('div', { className: 'decide' },
        button('✓ Accept', 'accepted', () => decide(card, 'accepted')),
        button('✗ Reject', 'rejected', () => decide(card, 'rejected')),
        button('Note', '', () => write(card))));
    card.addEventListener('pointerdown', () => choose(card, false));
    paint(card);
  };

  document.documentElement.classList.add('scripted');
  byId('bar').hidden = false;
  byId('kept').textContent = verdicts.kept
    ? 'Verdicts are kept in this browser; export them to keep them for good.'
    : 'This browser does not keep verdicts of this page: export them before you close it.';
  cards.forEach(dress);
  filter.addEventListener('input', sift);
  filter.addEventListener('keydown', (event) => {
    if (event.key === 'Escape') filter.value = '', sift();
    if (event.key === 'Escape' || event.key === 'Enter') choose(current);
  });
  which.addEventListener('change', sift);
  byId('undo').addEventListener('click', undo);
  byId('size').addEventListener('click', closer);
  byId('save-csv').addEventListener('click', () => save(verdicts.csv(), 'text/csv', 'review.csv'));
  byId('save-json').addEventListener('click', () => save(verdicts.json(), 'application/json', 'review.json'));
  byId('load').addEventListener('click', () => byId('load-file').click());
  byId('load-file').addEventListener('change', ({ target }) => {
    if (target.files[0]) load(target.files[0]).then(() => { target.value = ''; });
  });
  byId('help').addEventListener('click', () => byId('keys').showModal());
  document.addEventListener('keydown', (event) => {
    const typing = event.target.closest('input, select, textarea, dialog');
    if (typing || event.ctrlKey || event.metaKey || event.altKey || !current) return;
    const act = keys[event.key];
    if (!act || byId('keys').open) return;
    event.preventDefault();
    act();
  });
  choose(current, false);
  sift();
}

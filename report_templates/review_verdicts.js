'use strict';
// What was decided about the results of a review page: kept in the browser where it allows that,
// undone, handed out and read back as CSV and JSON. Knows nothing of what the page looks like.
class Verdicts {
  static fields = ['result', 'verdict', 'note', 'time', 'scan', 'scan_sha256', 'result_digest'];
  static words = ['accepted', 'rejected', ''];

  #place; #decided = new Map(); #before = [];

  // `results`: {result, scan, scan_sha256, result_digest} each, in the page's order.
  constructor(page, results) {
    this.results = results;
    this.#place = `regarment-review-${page}`;
    try {
      for (const one of JSON.parse(localStorage.getItem(this.#place) ?? '[]')) this.#take(one);
      localStorage.setItem(this.#place, JSON.stringify(this.#rows()));
      this.kept = true;
    } catch {
      this.kept = false;
    }
  }

  // {verdict, note, time, outdated}; outdated: given for other numbers of the same result.
  of(result) { return this.#decided.get(result) ?? { verdict: '', note: '', time: '' }; }
  get undoable() { return this.#before.length > 0; }

  set(result, change) {
    this.#before.push([[result, this.#decided.get(result)]]);
    this.#put(result, { ...this.of(result), outdated: '', ...change, time: new Date().toISOString() });
    this.#keep();
  }

  // The result last changed is as it was before; returns its name.
  undo() {
    const step = this.#before.pop();
    if (!step) return undefined;
    for (const [result, was] of step) {
      if (was) this.#decided.set(result, was);
      else this.#decided.delete(result);
    }
    this.#keep();
    return step[0]?.[0];
  }

  csv() {
    // A cell that a spreadsheet would take for a formula is led by an apostrophe.
    const cell = (text) => {
      const safe = /^[=+\-@\t\r']/.test(text) ? `'${text}` : text;
      return /[",\r\n]/.test(safe) ? `"${safe.replaceAll('"', '""')}"` : safe;
    };
    const lines = this.#rows(true).map((row) => Verdicts.fields.map((f) => cell(row[f])).join(','));
    return `${[Verdicts.fields.join(','), ...lines].join('\r\n')}\r\n`;
  }

  json() {
    return `${JSON.stringify({ schema: 'regarment.review/1', verdicts: this.#rows(true) }, null, 2)}\n`;
  }

  // Takes verdicts that csv() or json() wrote; of two about one result the later stays. Returns how
  // many were taken and how many are about results that are not here. Throws on anything else.
  read(text) {
    const rows = text.trimStart().startsWith('{') ? Verdicts.#fromJson(text) : Verdicts.#fromCsv(text);
    const step = [];
    let unknown = 0;
    for (const row of rows) {
      const was = this.#decided.get(row.result);
      if (!row.verdict && !row.note) continue;
      if (!this.results.some((r) => r.result === row.result)) unknown += 1;
      else if (!was || was.time <= row.time) {
        this.#take(row);
        step.push([row.result, was]);
      }
    }
    if (step.length > 0) this.#before.push(step);
    this.#keep();
    return { taken: step.length, unknown };
  }

  static #fromJson(text) {
    const { schema, verdicts } = JSON.parse(text);
    if (schema !== 'regarment.review/1' || !Array.isArray(verdicts)) throw new Error('no verdicts in it');
    return verdicts.map(Verdicts.#checked);
  }

  static #fromCsv(text) {
    const rows = [[]];
    // A cell in quotes or a plain one, and what ends it.
    for (const [all, quoted, plain, end] of text.matchAll(/(?:"((?:[^"]|"")*)"|([^,\r\n]*))(,|\r?\n|$)/gy)) {
      if (all === '' && rows.at(-1).length === 0) break;
      rows.at(-1).push((quoted?.replaceAll('""', '"') ?? plain).replace(/^'(?=[=+\-@\t\r'])/, ''));
      if (end === '') break;
      if (end !== ',') rows.push([]);
    }
    const [head, ...body] = rows.filter((row) => row.length > 0);
    if (!head?.includes('result') || !head.includes('verdict')) throw new Error('no columns result and verdict');
    return body.map((row) => Verdicts.#checked(Object.fromEntries(head.map((name, i) => [name, row[i] ?? '']))));
  }

  static #checked(row) {
    const out = Object.fromEntries(Verdicts.fields.map((f) => [f, String(row?.[f] ?? '').slice(0, 4000)]));
    if (!out.result || !Verdicts.words.includes(out.verdict)) throw new Error(`'${out.verdict.slice(0, 40)}' is no verdict`);
    return out;
  }

  #take(row) {
    const here = this.results.find((r) => r.result === row.result);
    if (!here) return;
    const { verdict, note, time } = Verdicts.#checked(row);
    const same = !row.result_digest || row.result_digest === here.result_digest;
    this.#put(row.result, same ? { verdict, note, time } : { verdict: '', note, time, outdated: verdict });
  }

  #put(result, entry) { this.#decided.set(result, entry); }

  #rows(all = false) {
    return this.results.filter((r) => all || this.#decided.has(r.result))
      .map((r) => ({ ...r, ...this.of(r.result) }))
      .map((row) => Object.fromEntries(Verdicts.fields.map((f) => [f, row[f]])));
  }

  #keep() {
    if (!this.kept) return;
    try {
      localStorage.setItem(this.#place, JSON.stringify(this.#rows()));
    } catch {
      this.kept = false;
    }
  }
}

'use strict';
// Verdicts that go to the service as they are given: it is they that count, not the browser's.
Verdicts = class extends Verdicts {
  #sent = Promise.resolve();

  constructor(page, results) {
    // What an earlier visit left in the browser is known to the service.
    localStorage.removeItem('regarment-review-queue');
    super('queue', results);
  }

  set(result, change) {
    super.set(result, change);
    this.#post(result);
  }

  undo() {
    return this.#postChanges(() => super.undo());
  }

  read(text) {
    return this.#postChanges(() => super.read(text));
  }

  // An import changes many at once, and so does taking it back.
  #postChanges(change) {
    const before = new Map(this.results.map(({ result }) => [result, JSON.stringify(this.of(result))]));
    const told = change();
    for (const [result, was] of before) if (JSON.stringify(this.of(result)) !== was) this.#post(result);
    return told;
  }

  // One after the other, so that the last verdict is the one that stays.
  #post(name) {
    const { result_digest: job } = this.results.find(({ result }) => result === name);
    const { verdict, note } = this.of(name);
    this.#sent = this.#sent.then(async () => {
      const line = document.getElementById('problem');
      try {
        // A note alone is a verdict that is open; neither is none.
        const answer = await fetch(`/v1/jobs/${job}/review`, verdict || note ? {
          method: 'POST', headers: { 'Content-Type': 'application/json' },
          body: JSON.stringify({ verdict: verdict || 'unsure', note }),
        } : { method: 'DELETE' });
        if (!answer.ok) throw new Error((await answer.json()).detail);
        line.hidden = true;
      } catch (error) {
        line.hidden = false;
        line.textContent = `The verdict on ${name} was not taken: ${error.message}`;
      }
    });
  }
};

'use strict';
// Tables of an evaluation sort by a click on a column's head, and the long ones have a box to filter
// them by; errors sort by their size. Without this script they stand as they are, the worst first.
{
  const make = (kind, properties, ...children) => {
    const element = Object.assign(document.createElement(kind), properties);
    element.append(...children);
    return element;
  };

  // The number a cell begins with; NaN where there is none, so that it comes last either way.
  const numberOf = (text) => {
    const found = /^[^\d+\u2212-]*([+\u2212-]?[\d\u202f]*\.?\d+)/.exec(text.trim());
    return found ? Number(found[1].replaceAll('\u202f', '').replace('\u2212', '-')) : NaN;
  };

  const sort = (head, column, descending) => {
    const body = head.closest('table').tBodies[0];
    const counted = head.classList.contains('n');
    const bySize = head.classList.contains('size');
    const keyOf = (row) => {
      const text = row.cells[column].textContent;
      if (!counted) return text.trim().toLowerCase();
      return bySize ? Math.abs(numberOf(text)) : numberOf(text);
    };
    const compare = (a, b) => (counted ? a - b : a.localeCompare(b, 'en', { numeric: true }));
    const rows = [...body.rows].map((row) => [keyOf(row), row]);
    const missing = rows.filter(([key]) => Number.isNaN(key));
    const known = rows.filter(([key]) => !Number.isNaN(key));
    known.sort(([a], [b]) => (descending ? compare(b, a) : compare(a, b)));
    body.append(...[...known, ...missing].map(([, row]) => row));
  };

  const addSorting = (table) => {
    const heads = [...table.tHead.rows[0].cells];
    heads.forEach((head, column) => {
      const button = make('button', { type: 'button', className: 'sort' }, ...head.childNodes);
      head.append(button);
      button.addEventListener('click', () => {
        // Numbers are asked for the largest first, words from a to z.
        const before = head.getAttribute('aria-sort');
        const descending = before ? before === 'ascending' : head.classList.contains('n');
        for (const other of heads) other.removeAttribute('aria-sort');
        head.setAttribute('aria-sort', descending ? 'descending' : 'ascending');
        sort(head, column, descending);
      });
    });
  };

  const addFilter = (table) => {
    const box = make('input', { type: 'search', autocomplete: 'off', spellcheck: false });
    const tally = make('span', { className: 'tally' });
    tally.setAttribute('role', 'status');
    const rows = [...table.tBodies[0].rows];
    const texts = rows.map((row) => row.textContent.toLowerCase());
    box.addEventListener('input', () => {
      const words = box.value.toLowerCase().split(/\s+/);
      let shown = 0;
      rows.forEach((row, i) => {
        row.hidden = !words.every((word) => texts[i].includes(word));
        shown += row.hidden ? 0 : 1;
      });
      tally.textContent = box.value.trim() ? `${shown} of ${rows.length}` : '';
    });
    const place = table.closest('.across') ?? table;
    place.before(make('p', { className: 'filter' }, make('label', {}, `${table.dataset.filter} `, box), tally));
  };

  document.querySelectorAll('table.sorts').forEach(addSorting);
  document.querySelectorAll('table[data-filter]').forEach(addFilter);
}

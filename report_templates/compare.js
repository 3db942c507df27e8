'use strict';
// Before and after: lays the pictures of one look over those of the other, with a line between them
// that moves in all views at once. Without this script the pictures stand one row above the other.
{
  const section = document.getElementById('pictures');
  const before = section && section.querySelector('.before');
  const choice = section && section.querySelector('.switch');

  const pictureOf = (look, view) => look.querySelector(`figure[data-view="${view}"] img`);

  const make = (kind, properties, ...children) => {
    const element = Object.assign(document.createElement(kind), properties);
    element.append(...children);
    return element;
  };

  // The picture under the line's left side, and the line, over each picture of a look.
  const lay = (figure) => {
    const under = figure.querySelector('img');
    const over = make('img', { className: 'over', alt: '', draggable: false });
    const stack = make('span', { className: 'stack' });
    under.draggable = false;
    under.replaceWith(stack);
    stack.append(under, over, make('span', { className: 'line-between' }));
    return { stack, over, view: figure.dataset.view };
  };

  const build = () => {
    const looks = [before, ...section.querySelectorAll('.after')];
    const stacks = looks.slice(1).flatMap((look) => [...look.querySelectorAll('figure[data-view]')].map(lay));
    const range = make('input', { type: 'range', min: 0, max: 100, step: 1, value: 50, id: 'line-at' });
    const left = make('select', { id: 'left-of-line' },
      ...looks.map((look) => make('option', { textContent: look.dataset.look })));

    const move = () => {
      section.style.setProperty('--at', `${range.value}%`);
      range.setAttribute('aria-valuetext', `${range.value} % ${left.value}`);
    };
    const show = () => {
      const look = looks[left.selectedIndex];
      for (const { over, view } of stacks) over.src = pictureOf(look, view).src;
      move();
    };
    const drag = (event) => {
      const stack = event.target.closest('.stack');
      if (!stack || (event.type === 'pointermove' && event.buttons !== 1)) return;
      const box = stack.getBoundingClientRect();
      range.value = 100 * (event.clientX - box.left) / box.width;
      move();
    };

    choice.querySelector('.after').before(make('div', { className: 'controls' },
      make('label', {}, 'Left of the line ', left),
      make('label', { className: 'slide' }, 'Line ', range)));
    range.addEventListener('input', move);
    left.addEventListener('change', show);
    choice.addEventListener('pointerdown', drag);
    choice.addEventListener('pointermove', drag);
    document.documentElement.classList.add('compares');
    show();
  };

  // A link that ends in #look-deviation opens that look; choosing one makes such a link.
  const link = () => {
    const wanted = document.getElementById(location.hash.slice(1));
    if (wanted && wanted.name === 'look') {
      wanted.checked = true;
      choice.scrollIntoView();
    }
    choice.addEventListener('change', (event) => {
      if (event.target.name === 'look') history.replaceState(null, '', `#${event.target.id}`);
    });
  };

  if (before && choice && choice.querySelector('.after')) {
    build();
    link();
  }
}

// Pages whose figures are drawn already: each is saved as it is, with the numbers that lie in it.
(() => {
  'use strict';
  for (const figure of document.querySelectorAll('figure[data-name]')) {
    const picture = figure.querySelector('svg');
    const numbers = figure.querySelector('.csv');
    figure.after(tautline.saveButtons({ name: figure.dataset.name, what: figure.getAttribute('aria-label'),
      svg: () => `${new XMLSerializer().serializeToString(picture)}\n`, numbers: () => numbers.textContent }));
  }
})();

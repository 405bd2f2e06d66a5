// The search, and the list of pages on a narrow screen. Without scripts the pages are all there.
'use strict';
(() => {
  const root = document.currentScript.dataset.root;
  const [form, field, found] = ['form[role=search]', '#search', '#found'].map((name) => document.querySelector(name));
  const pages = document.querySelector('nav.pages details');
  const narrow = matchMedia('(max-width: 52rem)');
  const fold = () => { pages.open = !narrow.matches; };
  narrow.addEventListener('change', fold);
  fold();
  form.hidden = false;
  const here = document.querySelector('nav.pages [aria-current]');
  const list = document.querySelector('nav.pages');
  if (here) { list.scrollTop = here.offsetTop - list.clientHeight / 2; }

  // the index is as large as all pages: it comes when somebody searches
  let index = null;
  const load = () => (index ??= new Promise((ready) => {
    const script = document.createElement('script');
    script.src = `${root}/search_index.js`;
    script.onload = () => ready(PAGES);
    document.head.append(script);
  }));

  const times = (text, word) => text.toLowerCase().split(word).length - 1;
  const score = ([, title, heading, text], words) => words.reduce((sum, word) => {
    const here = 20 * Math.min(1, times(heading, word)) + 12 * Math.min(1, times(title, word)) + Math.min(5, times(text, word));
    return here && sum !== null ? sum + here : null;
  }, 0);
  const element = (name, text) => Object.assign(document.createElement(name), { textContent: text });

  function excerpt(text, word) {
    const at = Math.max(0, text.toLowerCase().indexOf(word));
    const [start, end] = [Math.max(0, at - 50), at + 110];
    const line = element('span', start ? '…' : '');
    line.append(text.slice(start, at), element('mark', text.slice(at, at + word.length)), text.slice(at + word.length, end).replace(/\s\S*$/, ' …'));
    return line;
  }

  async function search() {
    const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
    const all = words.length ? await load() : [];
    const best = all.map((page) => [score(page, words), page]).filter(([points]) => points)
      .sort(([a], [b]) => b - a);
    const list = document.createElement('ol');
    for (const [, [place, title, heading, text]] of best.slice(0, 12)) {
      const link = Object.assign(document.createElement('a'), { href: `${root}/${place}` });
      link.append(element('b', heading || title), heading ? ` – ${title}` : '', excerpt(text, words[0]));
      list.append(document.createElement('li'));
      list.lastChild.append(link);
    }
    const count = Object.assign(element('p', best.length ? `${best.length} places${best.length > 12 ? ', the best 12' : ''}`
      : `Nothing has all of: ${words.join(' ')}`), { role: 'status' });
    found.replaceChildren(count, list);
    found.hidden = !words.length;
  }
  const close = () => { found.hidden = true; };

  field.addEventListener('input', search);
  field.addEventListener('focus', () => { load(); if (field.value) { search(); } });
  found.addEventListener('click', (event) => { if (event.target.closest('a')) { close(); } });
  form.addEventListener('submit', (event) => { event.preventDefault(); found.querySelector('a')?.click(); });
  document.addEventListener('click', (event) => { if (!found.contains(event.target) && event.target !== field) { close(); } });
  document.addEventListener('keydown', (event) => {
    const links = [field, ...found.querySelectorAll('a')];
    const at = links.indexOf(document.activeElement);
    if (event.key === '/' && !/INPUT|TEXTAREA|SELECT/.test(document.activeElement.tagName)) {
      event.preventDefault();
      field.focus();
    } else if (event.key === 'Escape' && !found.hidden) {
      field.value = '';
      close();
      field.focus();
    } else if (!found.hidden && at >= 0 && (event.key === 'ArrowDown' || event.key === 'ArrowUp')) {
      event.preventDefault();
      links[(at + (event.key === 'ArrowDown' ? 1 : links.length - 1)) % links.length].focus();
    }
  });
})();

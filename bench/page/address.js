// The state of the page in its address, so that a maintainer can link to what he sees:
// "#section?key=value&...". `model`, `case` and `step` hold for the whole page, and so do `engines`, those
// that are shown (none: all), and `off`, models that are not. A part of the page has keys of its
// own, such as "cases.sort" and "replay.t".
(() => {
  'use strict';
  const listeners = [];
  let query = new URLSearchParams();
  let section = '';

  function read() {
    const [name, values] = location.hash.slice(1).split('?');
    // a link of the contents names a section alone: the state stays
    if (values !== undefined || name === '') {
      query = new URLSearchParams(values || '');
    }
    section = name;
  }
  const text = () => {
    const values = query.toString().replaceAll('%2F', '/').replaceAll('%2C', ',');
    return `#${section}${values ? `?${values}` : ''}`;
  };
  const tell = () => listeners.forEach((listener) => listener());

  /// Opens what is folded around the section and goes there.
  function arrive() {
    const target = section && document.getElementById(decodeURIComponent(section));
    if (target) {
      for (let at = target; at; at = at.parentElement) {
        if (at.tagName === 'DETAILS') {
          at.open = true;
        }
      }
      target.scrollIntoView();
    }
  }

  const get = (key) => query.get(key) || '';
  const list = (key) => get(key).split(',').filter(Boolean);

  /// Sets values, '' removes one; with `to` a section of the page, a step back leads to what was.
  function set(values, to) {
    for (const [key, value] of Object.entries(values)) {
      if (value) {
        query.set(key, value);
      } else {
        query.delete(key);
      }
    }
    if (to) {
      section = to;
      history.pushState(null, '', text());
    } else {
      history.replaceState(null, '', text());
    }
    tell();
    if (to) {
      arrive();
    }
  }

  /// Calls `action` now and whenever one of `keys` has another value; without any, at every change.
  function listen(action, keys) {
    let before = null;
    const listener = () => {
      const now = keys && keys.map(get).join('\n');
      if (!keys || now !== before) {
        before = now;
        action();
      }
    };
    listeners.push(listener);
    listener();
  }

  addEventListener('hashchange', () => {
    read();
    if (!location.hash.includes('?') && query.size > 0) {
      history.replaceState(null, '', text());
    }
    tell();
    arrive();
  });
  read();
  // when all parts of the page are there
  addEventListener('load', () => {
    if (section && query.size > 0) {
      arrive();
    }
  });

  tautline.address = { get, list, set, listen };
})();

// What a reader takes from a page: every figure as SVG, its numbers as CSV, and the whole on paper. The
// page makes the files itself, so that it works from disk and without a network.
window.tautline = (() => {
  'use strict';

  /// `rows` below `columns` as CSV (RFC 4180); what is not known is an empty cell.
  function csv({ columns, rows }) {
    const cell = (value) => {
      const text = value === null || value === undefined ? '' : String(value);
      return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
    };
    return [columns, ...rows].map((row) => `${row.map(cell).join(',')}\n`).join('');
  }

  function save(name, type, text) {
    const link = document.createElement('a');
    link.href = URL.createObjectURL(new Blob([text], { type }));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10_000); // the browser reads it after the click
  }

  /// Two buttons that save a figure. `name` is that of the files, `what` of the figure for a reader who
  /// does not see it; `svg` and `numbers` return the texts, or promises of them.
  function saveButtons({ name, what, svg, numbers }) {
    const row = document.createElement('div');
    row.className = 'save';
    for (const [text, suffix, type, content] of [['Save as SVG', 'svg', 'image/svg+xml', svg],
      ['Save numbers as CSV', 'csv', 'text/csv', numbers]]) {
      const button = document.createElement('button');
      button.type = 'button';
      button.textContent = text;
      button.setAttribute('aria-label', `${text}: ${what}`);
      button.addEventListener('click', async () => save(`${name}.${suffix}`, type, await content()));
      row.append(button);
    }
    return row;
  }

  // on paper every fold is open
  let folded = [];
  addEventListener('beforeprint', () => {
    folded = [...document.querySelectorAll('main details:not([open]), header details:not([open])')];
    folded.forEach((one) => { one.open = true; });
  });
  addEventListener('afterprint', () => folded.forEach((one) => { one.open = false; }));

  return { csv, saveButtons };
})();

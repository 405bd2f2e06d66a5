// A page that `tautline bench` wrote, with another report put into it for the scripts.

/// `report` as the text of a script element: no "<" can end it.
const escaped = (report) => JSON.stringify(report).replace(/</g, '\\u003c').replace(/\u2028/g, '\\u2028')
  .replace(/\u2029/g, '\\u2029');

/// `page` with `report` for its own; what the program wrote in HTML stays.
export function withReport(page, report) {
  return page.replace(/(<script type="application\/json" id="report-data">)[^<]*/,
    (whole, tag) => tag + escaped(report));
}

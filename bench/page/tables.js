// Sorting and filtering of the page's tables. What the tables say stands in the page without this; the
// order and the filters are part of the address, so that a view can be passed on.
"use strict";

(() => {
  // state: "#section?table.key=value&..."
  const address = () => {
    const [section, query] = location.hash.slice(1).split("?");
    return { section, query: new URLSearchParams(query ?? "") };
  };

  const remember = (name, state) => {
    const { query } = address();
    for (const key of [...query.keys()]) {
      if (key.startsWith(name + ".")) query.delete(key);
    }
    for (const [key, value] of Object.entries(state)) {
      if (value) query.set(`${name}.${key}`, value);
    }
    const text = query.toString();
    history.replaceState(null, "", `#${name}${text ? "?" + text : ""}`);
  };

  const recalled = (name) => {
    const state = {};
    for (const [key, value] of address().query) {
      if (key.startsWith(name + ".")) state[key.slice(name.length + 1)] = value;
    }
    return state;
  };

  // each row once: its cells by the columns' keys, as numbers where they have one
  const read = (table, keys) => {
    const columns = [...keys.keys()];
    return [...table.tBodies].map((body) => ({
      body,
      rows: [...body.rows].map((row) => {
        const values = {};
        columns.forEach((key, index) => {
          const cell = row.cells[index];
          const value = cell?.dataset.value;
          const spread = (cell?.colSpan ?? 2) > 1;
          values[key] = spread || value === "" ? null : value === undefined ? cell.textContent : Number(value);
        });
        return { row, values, text: row.textContent.toLowerCase() };
      }),
    }));
  };

  const compare = (one, two) =>
    typeof one === "number" && typeof two === "number"
      ? one - two
      : String(one).localeCompare(String(two), "en", { numeric: true });

  // headings in the order of the columns, whatever row they stand in
  const headings = (table) => {
    const [upper, lower] = [...table.tHead.rows].map((row) => [...row.cells]);
    return upper.flatMap((cell) => (cell.scope === "colgroup" ? lower.splice(0, cell.colSpan) : [cell]));
  };

  // Rows keep their body: the control stays apart, and engines that are missing stay last.
  const order = (bodies, key, descending) => {
    for (const { body, rows } of bodies) {
      if (body.classList.contains("missing")) continue;
      const sorted = [...rows];
      if (key) {
        sorted.sort((a, b) => {
          const [one, two] = [a.values[key], b.values[key]];
          if (one === null || two === null) return (one === null) - (two === null); // none is last, either way
          return descending ? compare(two, one) : compare(one, two);
        });
      }
      body.append(...sorted.map(({ row }) => row));
    }
  };

  const filtered = (bodies, wanted) => {
    const words = (wanted.text ?? "").toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    let all = 0;
    for (const { body, rows } of bodies) {
      if (body.classList.contains("missing")) continue;
      const apart = body.classList.contains("control");
      for (const { row, values, text } of rows) {
        const fits = ["case", "engine", "model", "step"].every((key) =>
          !wanted[key] || !(key in values) || (apart && (key === "engine" || key === "model")) ||
          String(values[key]) === wanted[key]);
        const hidden = !(fits && (apart || words.every((word) => text.includes(word))));
        if (row.hidden !== hidden) row.hidden = hidden;
        if (!apart) {
          all += 1;
          shown += hidden ? 0 : 1;
        }
      }
    }
    return { shown, all };
  };

  const choice = (key, values, change) => {
    const label = document.createElement("label");
    label.textContent = key;
    const select = document.createElement("select");
    select.name = key;
    select.append(new Option("all", ""), ...values.map((value) => new Option(value, value)));
    select.addEventListener("change", change);
    label.append(select);
    return { label, input: select };
  };

  const search = (change) => {
    const label = document.createElement("label");
    label.textContent = "text";
    const input = document.createElement("input");
    input.type = "search";
    input.name = "text";
    input.addEventListener("input", change);
    label.append(input);
    return { label, input };
  };

  const set_up = (table, name, filter_keys) => {
    const cells = headings(table);
    const keys = new Map(cells.map((cell) => [cell.dataset.key, cell]));
    const bodies = read(table, keys);
    const inputs = new Map();
    let state = {};

    const bar = document.createElement("div");
    bar.className = "filters";
    const count = document.createElement("output");
    const reset = document.createElement("button");
    reset.type = "button";
    reset.textContent = "show all";

    const show = () => {
      for (const [key, cell] of keys) {
        if (key === state.sort) cell.setAttribute("aria-sort", state.order || "ascending");
        else cell.removeAttribute("aria-sort");
      }
      const { shown, all } = filtered(bodies, state);
      count.textContent = shown === all ? `${all} rows` : `${shown} of ${all} rows`;
      reset.hidden = shown === all;
    };
    const take = (next) => {
      const resort = next.sort !== state.sort || next.order !== state.order;
      state = next;
      for (const [key, input] of inputs) input.value = state[key] ?? "";
      if (resort) order(bodies, state.sort, state.order === "descending");
      show();
    };
    const change = (part) => {
      take({ ...state, ...part });
      remember(name, state);
    };

    for (const key of filter_keys) {
      const values = new Set();
      for (const { body, rows } of bodies) {
        if (body.className === "") rows.forEach((row) => values.add(String(row.values[key])));
      }
      const made = choice(key, [...values], (event) => change({ [key]: event.target.value }));
      inputs.set(key, made.input);
      bar.append(made.label);
    }
    const made = search((event) => change({ text: event.target.value }));
    inputs.set("text", made.input);
    reset.addEventListener("click", () =>
      change({ text: "", ...Object.fromEntries(filter_keys.map((key) => [key, ""])) }));
    bar.append(made.label, count, reset);
    table.parentElement.before(bar);

    for (const [key, cell] of keys) {
      if (!key) continue;
      const button = document.createElement("button");
      button.type = "button";
      button.append(...cell.childNodes);
      cell.append(button);
      // once up, once down, then as it was
      button.addEventListener("click", () =>
        change(state.sort !== key ? { sort: key, order: "ascending" }
          : state.order === "ascending" ? { sort: key, order: "descending" }
          : { sort: "", order: "" }));
    }

    take(recalled(name));
    addEventListener("hashchange", () => take(recalled(name)));
  };

  const go_to_section = () => {
    const { section, query } = address();
    if (section && query.size > 0) document.getElementById(section)?.scrollIntoView();
  };

  set_up(document.getElementById("answers-table"), "answers", ["engine", "model", "step"]);
  set_up(document.getElementById("cases-table"), "cases", ["case", "engine", "model", "step"]);
  addEventListener("hashchange", go_to_section);
  go_to_section();
})();

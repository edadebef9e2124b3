"use strict";
// The table of many parts: only the rows in view stand in the page. Neither "less than" nor "and" signs are
// used, so that the page is XML too.
(() => {
  const kRowHeight = 60;
  const kRowsBeyond = 8;
  const kSvg = "http://www.w3.org/2000/svg";
  const data = JSON.parse(document.getElementById("data-parts").textContent);
  const columns = data.columns;
  const rows = data.rows;
  const frame = document.getElementById("table-frame");
  const body = document.getElementById("table-rows");
  const search = document.getElementById("table-search");
  const filter = document.getElementById("table-outcome");
  const count = document.getElementById("table-count");
  const outcomeColumn = columns.findIndex((column) => column.kind === "outcome");

  // What a reader sees as words: neither pictures nor links. No word reaches over a line's end.
  const kWordKinds = ["part", "outcome", "text"];
  const wordColumns = [...columns.keys()].filter((at) => kWordKinds.includes(columns[at].kind));
  const words = rows.map((cells) => wordColumns.map((at) => cells[at]).join("\n").toLowerCase());

  let shown = rows.map((cells, place) => place);
  let sorted = { column: -1, down: false };
  let drawn = { shown: null, first: 0, last: 0 };

  const filled = (tag, child) => {
    const element = document.createElement(tag);
    element.append(child);
    return element;
  };

  const picture = (lines) => {
    const svg = document.createElementNS(kSvg, "svg");
    const path = document.createElementNS(kSvg, "path");
    svg.setAttribute("viewBox", data.pictureBox);
    svg.setAttribute("class", "small");
    path.setAttribute("d", lines);
    svg.append(path);
    return svg;
  };

  const link = (text, target) => {
    if (!target) return document.createTextNode(text);
    const anchor = filled("a", text);
    anchor.setAttribute("href", target);
    return anchor;
  };

  const makers = {
    picture: (cell) => picture(cell || ""),
    part: (cell, cells) => link(cell, cells[columns.length]),
    number: (cell, cells, column) => (cell === null ? "" : cell.toFixed(column.decimals)),
    outcome: (cell) => cell,
    text: (cell) => cell,
  };

  const cellOf = (cells, column, at) => {
    const cell = filled("td", makers[column.kind](cells[at], cells, column));
    if (column.kind === "number") cell.className = "n";
    if (column.kind === "outcome") cell.className = "is-" + cells[at];
    if (typeof cells[at] === "string") if (column.kind !== "picture") cell.title = cells[at];
    return cell;
  };

  const rowOf = (place) => {
    const row = document.createElement("tr");
    row.className = "part";
    row.append(...columns.map((column, at) => cellOf(rows[place], column, at)));
    return row;
  };

  const spacer = (length) => {
    const row = document.createElement("tr");
    row.style.height = length * kRowHeight + "px";
    return row;
  };

  // Measured when the window changes alone: asking for it lays the whole page out.
  let seen = 0;
  const measure = () => {
    seen = Math.ceil(frame.clientHeight / kRowHeight) + 2 * kRowsBeyond;
  };

  const draw = (top) => {
    const first = Math.max(0, Math.min(Math.floor(top / kRowHeight) - kRowsBeyond, shown.length - seen));
    const last = Math.min(shown.length, first + seen);
    if (drawn.shown === shown) if (drawn.first === first) if (drawn.last === last) return;
    drawn = { shown, first, last };
    body.replaceChildren(spacer(first), ...shown.slice(first, last).map(rowOf), spacer(shown.length - last));
  };

  const isEmpty = (cell) => cell === null || cell === "";

  // Of each row, the place of its value among the column's different values: what is sorted is numbers. Empty
  // cells have the place behind the last.
  const ranksOf = (column) => {
    const values = [...new Set(rows.map((cells) => cells[column]))].filter((cell) => !isEmpty(cell));
    if (columns[column].kind === "number") values.sort((a, b) => a - b);
    else values.sort();
    const places = new Map(values.map((value, place) => [value, place]));
    const ranks = rows.map((cells) => (isEmpty(cells[column]) ? values.length : places.get(cells[column])));
    return { ranks, values: values.length };
  };
  const known = new Map();
  const knownRanks = (column) => {
    if (!known.has(column)) known.set(column, ranksOf(column));
    return known.get(column);
  };

  // Empty cells come last whichever way is sorted; equal ones stay in the list's order.
  const inOrder = (places) => {
    if (sorted.column === -1) return places;
    const { ranks, values } = knownRanks(sorted.column);
    const turned = (rank) => (!sorted.down || rank === values ? rank : values - 1 - rank);
    const keys = Float64Array.from(places, (place) => turned(ranks[place]) * rows.length + place);
    return Array.from(keys.sort(), (key) => key % rows.length);
  };

  const choose = () => {
    const wanted = search.value.toLowerCase().split(" ").filter((word) => word !== "");
    const places = [];
    const outcome = filter.value;
    rows.forEach((cells, place) => {
      if (outcome === "" || cells[outcomeColumn] === outcome)
        if (wanted.every((word) => words[place].includes(word))) places.push(place);
    });
    shown = inOrder(places);
    count.textContent = shown.length + " of " + rows.length + " parts";
    draw(0);
    frame.scrollTop = 0;
  };

  const sortBy = (column, heads) => {
    sorted = { column, down: sorted.column === column ? !sorted.down : false };
    heads.forEach((head, at) =>
      head.setAttribute("aria-sort", at !== column ? "none" : sorted.down ? "descending" : "ascending"));
    choose();
  };

  const heads = [...document.querySelectorAll("#table-frame th")];
  heads.forEach((head, at) => {
    if (columns[at].kind === "picture") return;
    head.querySelector("button").addEventListener("click", () => sortBy(at, heads));
  });
  search.addEventListener("input", choose);
  filter.addEventListener("input", choose);
  frame.addEventListener("scroll", () => requestAnimationFrame(() => draw(frame.scrollTop)));
  window.addEventListener("resize", () => {
    measure();
    draw(frame.scrollTop);
  });
  measure();
  choose();
})();

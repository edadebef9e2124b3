"use strict";
// The table of many parts: only the rows in view stand in the page. Neither "less than" nor "and" signs are
// used, so that the page is XML too.
(() => {
  const kRowHeight = 60;
  const kRowsBeyond = 8;
  const kSvg = "http://www.w3.org/2000/svg";
  const data = JSON.parse(document.getElementById("data-parts").textContent);
  const columns = data.columns;
  const frame = document.getElementById("table-frame");
  const body = document.getElementById("table-rows");
  const search = document.getElementById("table-search");
  const filter = document.getElementById("table-outcome");
  const count = document.getElementById("table-count");
  const outcomeColumn = columns.findIndex((column) => column.kind === "outcome");
  const parts = data.rows.map((cells, place) => ({
    cells, place, words: cells.filter((cell) => typeof cell === "string").join(" ").toLowerCase(),
  }));
  let shown = parts;
  let sorted = { column: -1, down: false };

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

  const spacer = (rows) => {
    const row = document.createElement("tr");
    row.style.height = rows * kRowHeight + "px";
    return row;
  };

  const draw = () => {
    const first = Math.max(0, Math.floor(frame.scrollTop / kRowHeight) - kRowsBeyond);
    const seen = Math.ceil(frame.clientHeight / kRowHeight) + 2 * kRowsBeyond;
    const last = Math.min(shown.length, first + seen);
    const rows = shown.slice(first, last).map((part) => {
      const row = document.createElement("tr");
      row.className = "part";
      row.append(...columns.map((column, at) => cellOf(part.cells, column, at)));
      return row;
    });
    body.replaceChildren(spacer(first), ...rows, spacer(shown.length - last));
  };

  // Empty cells come last whichever way is sorted.
  const compare = (a, b) => {
    const one = a.cells[sorted.column];
    const other = b.cells[sorted.column];
    if (one === other) return a.place - b.place;
    if (one === null || one === "") return 1;
    if (other === null || other === "") return -1;
    return (one > other ? 1 : -1) * (sorted.down ? -1 : 1);
  };

  const choose = () => {
    const words = search.value.toLowerCase().split(" ").filter((word) => word !== "");
    const fits = (part) => (filter.value === "" || part.cells[outcomeColumn] === filter.value)
      ? words.every((word) => part.words.includes(word)) : false;
    shown = parts.filter(fits);
    if (sorted.column > -1) shown.sort(compare);
    count.textContent = shown.length + " of " + parts.length + " parts";
    frame.scrollTop = 0;
    draw();
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
  frame.addEventListener("scroll", () => requestAnimationFrame(draw));
  window.addEventListener("resize", draw);
  choose();
})();

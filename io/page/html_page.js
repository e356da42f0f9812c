// Functions of a page except charts: printing, tables that scroll or sort. Sends the event "scheme" to the document
// when the colours of the page change (dark, light, paper), so that canvases are drawn again.
const printing = (on) => {
  document.documentElement.toggleAttribute("data-printing", on);
  for (const part of document.querySelectorAll("details:not(.commands, .screen)")) {
    if (on) part.dataset.was = part.open ? "open" : "";
    part.open = on || part.dataset.was === "open";
  }
  document.dispatchEvent(new Event("scheme"));
};
addEventListener("beforeprint", () => printing(true));
addEventListener("afterprint", () => printing(false));
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => document.dispatchEvent(new Event("scheme")));

// A box that scrolls is a stop of the keyboard; other boxes are not.
const boxes = () => {
  for (const box of document.querySelectorAll(".scroll"))
    if (box.scrollWidth > box.clientWidth) box.tabIndex = 0;
    else box.removeAttribute("tabindex");
};
addEventListener("resize", boxes);
document.addEventListener("toggle", boxes, true);
boxes();

// A box above a long table keeps the rows that hold its words; the marks in it keep the rows with this mark.
const kFiltered = 5;
const filterOf = (table, body) => {
  const box = Object.assign(document.createElement("div"), { className: "filter" });
  const label = document.createElement("label"), input = Object.assign(document.createElement("input"), { type: "search" });
  const count = document.createElement("output");
  label.append("Filter ", input);
  box.append(label);
  const words = { bad: "bad", warn: "warning", unknown: "unknown", good: "good" };
  const markOf = (row) => {  // the first mark of a row is its verdict
    const cell = row.querySelector("td.bad, td.warn, td.unknown, td.good");
    return Object.keys(words).find((mark) => cell?.classList.contains(mark)) ?? "";
  };
  let only = "";
  const keep = () => {
    const wanted = input.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    for (const row of body.rows) {
      const text = row.textContent.toLowerCase();
      row.hidden = !wanted.every((word) => text.includes(word)) || (only !== "" && markOf(row) !== only);
      shown += !row.hidden;
    }
    count.textContent = shown === body.rows.length ? "" : shown + " of " + body.rows.length + " rows";
  };
  for (const mark of Object.keys(words)) {
    const number = [...body.rows].filter((row) => markOf(row) === mark).length;
    if (number === 0) continue;
    const button = Object.assign(document.createElement("button"), { type: "button", ariaPressed: "false", ariaLabel: words[mark] + ": " + number + " rows" });
    button.append(Object.assign(document.createElement("span"), { className: mark, textContent: number }));
    button.addEventListener("click", () => {
      only = only === mark ? "" : mark;
      for (const other of box.querySelectorAll("button")) other.ariaPressed = String(other === button && only !== "");
      keep();
    });
    box.append(button);
  }
  input.addEventListener("input", keep);
  box.append(count);
  table.closest(".scroll").before(box);
};

// A click on the sign of a column sorts by the column, a second click reverses the order. Words follow numbers in both.
for (const table of document.querySelectorAll("table.sortable")) {
  const body = table.tBodies[0], heads = [...table.tHead.rows[0].cells];
  const key = (row, k) => {
    const cell = row.cells[k], text = cell.dataset.value ?? cell.textContent.trim(), number = Number.parseFloat(text);
    return Number.isFinite(number) ? number : text;
  };
  const before = (a, b, way) => typeof a === typeof b ? way * (a < b ? -1 : a > b ? 1 : 0) : typeof a === "number" ? -1 : 1;
  for (const [k, head] of heads.entries()) {
    const button = document.createElement("button");
    button.className = "sort";
    button.textContent = "\u2195";
    button.ariaLabel = "sort by " + head.textContent;
    button.addEventListener("click", () => {
      const down = head.ariaSort === "ascending";
      for (const other of heads) other.ariaSort = null;
      head.ariaSort = down ? "descending" : "ascending";
      body.append(...[...body.rows].sort((a, b) => before(key(a, k), key(b, k), down ? -1 : 1)));
    });
    if (head.textContent) head.append(button);
  }
  if (body.rows.length > kFiltered) filterOf(table, body);
}

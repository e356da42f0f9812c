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
    head.append(button);
  }
}

// Draws every plot, without animation, and sets a mark for which a test can wait. Each series has its own colour, dash
// and shape, so that plots do not depend on colour alone.
const kDashes = [[], [11, 3], [7, 3, 2, 3], [2, 3], [14, 4, 3, 4], [5, 5], [1, 4], [9, 3, 2, 3, 2, 3]];
const kShapes = ["circle", "triangle", "rect", "rectRot", "crossRot", "star", "cross", "dash"];
const kMostInLegend = 16;
Chart.defaults.font.family = 'system-ui, "DejaVu Sans", sans-serif';
Chart.defaults.animation = false;
// Letters, points and lines follow the size of the page's text, which is smaller on paper.
const sized = (pixels) => pixels * Number.parseFloat(getComputedStyle(document.documentElement).fontSize) / 16;
const colour = (name) => getComputedStyle(document.documentElement).getPropertyValue("--" + name).trim();

// Ticks of a logarithmic axis: 1, 2 and 5 times a power of ten, in few digits.
const decade = (value) => {
  const digit = Math.round(value / 10 ** Math.floor(Math.log10(value) + 1e-9));
  if (![1, 2, 5].includes(digit)) return "";
  return value >= 1e-3 && value < 1e4 ? String(Number(value.toPrecision(2))) : value.toExponential(0);
};

// Names next to points if there is room: right of the point, else left, above or below. Otherwise only the tooltip
// has the name.
const pointNames = {
  id: "pointNames",
  afterDatasetsDraw(chart) {
    const { ctx, chartArea: area } = chart, taken = [];
    const spots = chart.data.datasets.flatMap((set, k) => set.faint ? [] : (set.names ?? []).map((name, j) => {
      const at = chart.getDatasetMeta(k).data[j];
      return { name, x: at.x, y: at.y };
    }));
    for (const [k, set] of chart.data.datasets.entries())
      if (!set.showLine)
        for (const { x, y } of chart.getDatasetMeta(k).data) taken.push([x - 5, y - 5, x + 5, y + 5]);
    ctx.save();
    ctx.font = sized(11) + "px " + Chart.defaults.font.family;
    ctx.textBaseline = "middle";
    Object.assign(ctx, { fillStyle: colour("text"), strokeStyle: colour("back"), lineWidth: 3, lineJoin: "round" });
    for (const { name, x, y } of spots) {
      const width = ctx.measureText(name).width;
      const free = [[x + 7, y], [x - 7 - width, y], [x - width / 2, y - 12], [x - width / 2, y + 12]].find(([left, middle]) => {
        const box = [left - 1, middle - 7, left + width + 1, middle + 7];
        if (box[0] < area.left || box[2] > chart.width || box[1] < 0 || box[3] > area.bottom + 8) return false;
        return taken.every((t) => t[2] <= box[0] || t[0] >= box[2] || t[3] <= box[1] || t[1] >= box[3]);
      });
      if (!free) continue;
      ctx.strokeText(name, free[0], free[1]);
      ctx.fillText(name, free[0], free[1]);
      taken.push([free[0], free[1] - 7, free[0] + width, free[1] + 7]);
    }
    ctx.restore();
  },
};

// `whole`: all values are whole numbers, so ticks are whole numbers too.
const axisOf = (log, range, edge, whole) => ({
  type: log ? "logarithmic" : "linear",
  min: edge ? edge.at : range?.[0],
  max: range?.[1],
  grid: { color: colour("line") },
  border: { color: colour("faint") },
  ticks: {
    color: colour("dim"), maxRotation: 0, ...(whole ? { precision: 0 } : {}),
    ...(log ? { callback: (value) => edge && value <= edge.at * 1.001 ? edge.label
      : edge && value < edge.least ? "" : decade(value) } : {}),
  },
});

const datasetsOf = (plot) => plot.series.flatMap((s, k) => {
  const faint = s.style.startsWith("faint"), points = s.style.endsWith("points"), index = (s.colour ?? k) % 8;
  const drawn = colour(faint ? "faint" : "c" + index);
  const line = {
    label: s.label, role: s.role, entry: plot.entries[k], data: s.x.map((x, j) => ({ x, y: s.y[j] })), names: s.names, faint, borderColor: drawn,
    backgroundColor: faint && points ? "transparent" : drawn, borderWidth: sized(faint ? 1 : 2), showLine: !points,
    borderDash: s.style === "dashed" ? [6, 4] : faint ? [] : kDashes[index].map(sized), clip: 6, spanGaps: false,
    pointStyle: faint ? "circle" : kShapes[index], pointRadius: !points ? 0 : sized(index < 4 ? 3.5 : 5), pointBorderWidth: sized(1.5),
  };
  const edge = (values, fill) => ({ label: "", entry: plot.entries[k], isEdge: true, data: s.x.map((x, j) => ({ x, y: values[j] })), showLine: true,
    borderWidth: 0, pointRadius: 0, fill, drawn, backgroundColor: drawn + "38" });
  return s.low ? [edge(s.low, false), edge(s.high, "-1"), line] : [line];
});

// A curve belongs to the entry of the legend with its label, or with its colour if it has no label.
const entriesOf = (plot) => {
  const labels = [];
  plot.entries = plot.series.map((s, k) => s.label || plot.series.find((o) => o.label && o.colour !== undefined && o.colour === s.colour)?.label || "");
  plot.series.forEach((s, k) => {
    if (s.label && !labels.some((l) => l.text === s.label)) labels.push({ text: s.label, on: !s.hidden, series: k });
  });
  return labels;
};

// The sign in the legend: the line with its dash and the shape of its points.
const signOf = (line, points) => {
  const sign = Object.assign(document.createElement("canvas"), { width: 34, height: 12 });
  const ctx = sign.getContext("2d");
  sign.ariaHidden = "true";
  Object.assign(ctx, { strokeStyle: line.borderColor, fillStyle: points?.backgroundColor ?? line.backgroundColor, lineWidth: line.borderWidth });
  if (line.showLine) {
    ctx.setLineDash(line.borderDash);
    ctx.beginPath();
    ctx.moveTo(0, 6);
    ctx.lineTo(34, 6);
    ctx.stroke();
    ctx.setLineDash([]);
  }
  if (points) Chart.helpers.drawPoint(ctx, { pointStyle: points.pointStyle, radius: 4, borderWidth: 1.5, rotation: 0 }, 17, 6);
  return sign;
};

// Shows and hides the curves by their entries, and states how many are shown.
const switchCurves = (chart, plot) => {
  chart.data.datasets.forEach((set, k) => {
    const entry = plot.labels.find((l) => l.text === set.entry);
    chart.setDatasetVisibility(k, entry ? entry.on : true);
  });
  chart.update();
  const shown = plot.labels.filter((l) => l.on).length, all = plot.counted ? plot.all : plot.labels.length;
  if (!plot.note) return;
  plot.note.textContent = shown === all ? "" : shown + " of " + all + " " + (plot.counted ?? "curves") + " shown"
    + (shown < plot.labels.length ? ". The legend switches the others on." : ".");
};

// The legend: a button for each entry, which switches its curve.
const legendOf = (chart, plot) => {
  const figure = chart.canvas.closest("figure"), box = figure.querySelector(".legend");
  box.replaceChildren(...(plot.labels.length < 2 || plot.labels.length > kMostInLegend ? [] : plot.labels.map((entry) => {
    const sets = chart.data.datasets.filter((set) => set.entry === entry.text && !set.isEdge);
    const line = sets.find((set) => set.showLine) ?? sets[0], points = sets.find((set) => !set.showLine);
    const button = document.createElement("button");
    button.type = "button";
    button.ariaPressed = String(entry.on);
    button.append(signOf(line, points), entry.text);
    button.addEventListener("click", () => {
      entry.on = !entry.on;
      button.ariaPressed = String(entry.on);
      switchCurves(chart, plot);
    });
    return button;
  })));
};

const digits = (value) => String(Number(value.toPrecision(4)));

// The values under the pointer in words: "fitted, incidence at 20 degrees: 0.123 at 35".
const tipOf = (item) => {
  const set = item.dataset, name = set.names?.[item.dataIndex] || [set.role, set.entry].filter(Boolean).join(", ");
  return (name ? name + ": " : "") + digits(item.parsed.y) + " at " + digits(item.parsed.x);
};

const chartOf = (plot, index) => {
  plot.labels ??= entriesOf(plot);
  const chart = new Chart(document.getElementById("plot" + index), {
    type: "scatter", data: { datasets: datasetsOf(plot) }, plugins: [pointNames],
    options: {
      maintainAspectRatio: false, responsive: true, interaction: { mode: "nearest", intersect: false },
      plugins: {
        legend: { display: false },
        tooltip: { filter: (item) => !item.dataset.isEdge, callbacks: { label: tipOf } },
      },
      scales: { x: axisOf(plot.log_x, plot.range_x, null, plot.series.every((s) => s.x.every(Number.isInteger))), y: axisOf(plot.log_y, plot.range_y, plot.bottom_edge) },
    },
  });
  legendOf(chart, plot);
  switchCurves(chart, plot);
  return chart;
};

// The numbers of the plot, one row per point, with the curves that are switched off.
const csvOf = (plot) => {
  const quoted = (text) => /[",\n]/.test(text) ? '"' + text.replaceAll('"', '""') + '"' : text;
  const rows = [["curve", plot.x_label, plot.y_label, "low", "high"]];
  plot.series.forEach((s, k) => s.x.forEach((x, j) => rows.push(
    [[s.role, plot.entries[k], s.names?.[j]].filter(Boolean).join(", "), x ?? "", s.y[j] ?? "", s.low?.[j] ?? "", s.high?.[j] ?? ""])));
  return rows.map((row) => row.map((cell) => quoted(String(cell))).join(",")).join("\n") + "\n";
};

// The chart as it is drawn, as lines and text.
const svgOf = (chart, plot) => {
  const { chartArea: area, scales: { x: sx, y: sy } } = chart, font = Chart.defaults.font.family.replaceAll('"', "'");
  const safe = (text) => String(text).replaceAll("&", "&amp;").replaceAll("<", "&lt;"), at = (v) => v.toFixed(1);
  const text = (x, y, words, anchor, more = "") =>
    `<text x="${at(x)}" y="${at(y)}" text-anchor="${anchor}"${more}>${safe(words)}</text>`;
  const top = 46, width = chart.width, height = chart.height + top + 24, parts = [];
  const line = (x1, y1, x2, y2) => `<line x1="${at(x1)}" y1="${at(y1)}" x2="${at(x2)}" y2="${at(y2)}" stroke="${colour("line")}"/>`;
  for (const [k, tick] of sx.ticks.entries()) {
    const x = sx.getPixelForTick(k);
    parts.push(line(x, area.top, x, area.bottom), text(x, area.bottom + 16, tick.label ?? "", "middle"));
  }
  for (const [k, tick] of sy.ticks.entries()) {
    const y = sy.getPixelForTick(k);
    parts.push(line(area.left, y, area.right, y), text(area.left - 6, y + 4, tick.label ?? "", "end"));
  }
  const placesOf = (k) => chart.getDatasetMeta(k).data.filter((p) => !p.skip && Number.isFinite(p.x) && Number.isFinite(p.y));
  const path = (places) => places.map((p) => at(p.x) + "," + at(p.y)).join(" ");
  const marks = { circle: "M-4 0a4 4 0 1 0 8 0a4 4 0 1 0 -8 0", triangle: "M0-4.5L4.2 3.2H-4.2Z", rect: "M-3.4-3.4H3.4V3.4H-3.4Z", rectRot: "M0-4.6L4.6 0L0 4.6L-4.6 0Z" };
  const other = "M-4-4L4 4M-4 4L4-4";
  chart.data.datasets.forEach((set, k) => {
    if (!chart.isDatasetVisible(k)) return;
    const places = placesOf(k);
    if (set.isEdge && set.fill) parts.push(`<polygon points="${path(placesOf(k - 1))} ${path(places.slice().reverse())}" fill="${set.drawn}" fill-opacity=".22"/>`);
    else if (set.isEdge) return;
    else if (set.showLine) parts.push(`<polyline points="${path(places)}" fill="none" stroke="${set.borderColor}" stroke-width="2" stroke-dasharray="${set.borderDash.join(" ")}"/>`);
    else for (const p of places) parts.push(`<path d="${marks[set.pointStyle] ?? other}" transform="translate(${at(p.x)} ${at(p.y)})" fill="${set.backgroundColor === "transparent" ? "none" : set.backgroundColor}" stroke="${set.borderColor}"/>`);
  });
  let left = area.left;
  const names = plot.labels.filter((l) => l.on).map((l) => {
    const set = chart.data.datasets.find((d) => d.entry === l.text && !d.isEdge), x = left;
    left += 46 + 7 * l.text.length;
    return `<line x1="${x}" y1="34" x2="${x + 28}" y2="34" stroke="${set.borderColor}" stroke-width="2" stroke-dasharray="${set.borderDash.join(" ")}"/>` + text(x + 34, 38, l.text, "start");
  });
  const space = "http:" + "//www.w3.org/2000/svg";  // the name of the format; nothing is loaded
  return `<svg xmlns="${space}" width="${width}" height="${height}" viewBox="0 0 ${width} ${height}" font-family="${font}" font-size="12" fill="${colour("text")}">`
    + `<rect width="100%" height="100%" fill="${colour("back")}"/>` + text(8, 18, plot.title, "start", ' font-weight="600"') + (plot.labels.length > 1 ? names.join("") : "")
    + `<g transform="translate(0 ${top})"><clipPath id="a"><rect x="${area.left - 6}" y="${area.top - 6}" width="${area.width + 12}" height="${area.height + 12}"/></clipPath>${parts.join("")}`
    + text(area.left, area.top - 4, plot.y_label, "start") + text((area.left + area.right) / 2, chart.height + 14, plot.x_label, "middle") + "</g></svg>";
};

const save = (name, type, content) => {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
};

// The legend above the chart, and below it the number of curves and the buttons that save.
plots.forEach((plot, index) => {
  const box = document.getElementById("plot" + index).closest(".chart");
  const add = (tag, name, after) => after(Object.assign(document.createElement(tag), { className: name }));
  add("div", "legend", (e) => box.closest("figure").querySelector(".title").after(e));
  add("p", "save", (e) => box.nextElementSibling.after(e));
  const row = box.closest("figure").querySelector(".save");
  plot.note = Object.assign(document.createElement("span"), { className: "shown" });
  row.append(plot.note);
  const name = plot.title.replace(/[^A-Za-z0-9]+/g, "_").replace(/^_|_$/g, "").toLowerCase();
  for (const [kind, type, make] of [["SVG", "image/svg+xml", () => svgOf(charts[index], plot)], ["CSV", "text/csv", () => csvOf(plot)]]) {
    const button = Object.assign(document.createElement("button"), { type: "button", textContent: kind, ariaLabel: "save " + plot.title + " as " + kind });
    button.addEventListener("click", () => save(name + "." + kind.toLowerCase(), type, make()));
    row.append(button);
  }
});

let charts = [];
const drawAll = () => {
  for (const chart of charts) chart.destroy();
  Chart.defaults.font.size = sized(12);
  charts = plots.map(chartOf);
  document.documentElement.dataset.plots = charts.length;
};
drawAll();
document.addEventListener("scheme", drawAll);

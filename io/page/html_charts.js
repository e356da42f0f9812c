// Draws every plot, without animation, and sets a mark for which a test can wait. Each series has its own colour, dash
// and shape, so that plots do not depend on colour alone.
const kDashes = [[], [11, 3], [7, 3, 2, 3], [2, 3], [14, 4, 3, 4], [5, 5], [1, 4], [9, 3, 2, 3, 2, 3]];
const kShapes = ["circle", "triangle", "rect", "rectRot", "crossRot", "star", "cross", "dash"];
const kMostInLegend = 8;
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
    label: s.label, data: s.x.map((x, j) => ({ x, y: s.y[j] })), names: s.names, faint, borderColor: drawn,
    backgroundColor: faint && points ? "transparent" : drawn, borderWidth: sized(faint ? 1 : 2), showLine: !points,
    borderDash: s.style === "dashed" ? [6, 4] : faint ? [] : kDashes[index].map(sized), clip: 6, spanGaps: false,
    pointStyle: faint ? "circle" : kShapes[index], pointRadius: !points ? 0 : sized(index < 4 ? 3.5 : 5), pointBorderWidth: sized(1.5),
  };
  const edge = (values, fill) => ({ label: "", data: s.x.map((x, j) => ({ x, y: values[j] })), showLine: true,
    borderWidth: 0, pointRadius: 0, fill, backgroundColor: drawn + "38" });
  return s.low ? [edge(s.low, false), edge(s.high, "-1"), line] : [line];
});

// The sign in the legend: the line with its dash and the shape of its points.
const signOf = (drawn, fill, dash, shape, width) => {
  const sign = Object.assign(document.createElement("canvas"), { width: 34, height: 11 });
  const ctx = sign.getContext("2d");
  Object.assign(ctx, { strokeStyle: drawn, fillStyle: fill, lineWidth: width });
  if (dash) {
    ctx.setLineDash(dash);
    ctx.beginPath();
    ctx.moveTo(0, 5.5);
    ctx.lineTo(34, 5.5);
    ctx.stroke();
    ctx.setLineDash([]);
  }
  if (shape) Chart.helpers.drawPoint(ctx, { pointStyle: shape, radius: 4, borderWidth: 1.5, rotation: 0 }, 17, 5.5);
  return sign;
};

// Returns the series with a label. A series takes the shape of unlabelled points with the same colour.
const legendOf = (chart) => chart.data.datasets.flatMap((set, k) => {
  if (set.label === "") return [];
  const points = set.showLine
    ? chart.data.datasets.find((d) => !d.showLine && d.label === "" && d.borderColor === set.borderColor) : set;
  return [{ text: set.label, datasetIndex: k, hidden: !chart.isDatasetVisible(k), fontColor: colour("text"),
    pointStyle: signOf(set.borderColor, points?.backgroundColor, set.showLine && set.borderDash, points?.pointStyle, set.borderWidth) }];
});

const chartOf = (plot, index) => {
  const labelled = plot.series.filter((s) => s.label !== "").length;
  return new Chart(document.getElementById("plot" + index), {
    type: "scatter", data: { datasets: datasetsOf(plot) }, plugins: [pointNames],
    options: {
      maintainAspectRatio: false, responsive: true,
      plugins: {
        legend: { display: labelled > 1 && labelled <= kMostInLegend,
          onClick: null,
          labels: { usePointStyle: true, pointStyleWidth: 34, boxHeight: sized(9), padding: sized(10), generateLabels: legendOf } },
        tooltip: { filter: (item) => item.dataset.label !== "" || item.dataset.names, callbacks: {
          label: (item) => (item.dataset.names?.[item.dataIndex] || item.dataset.label) + ": "
            + Number(item.parsed.x.toPrecision(4)) + ", " + Number(item.parsed.y.toPrecision(4)) } },
      },
      scales: { x: axisOf(plot.log_x, plot.range_x, null, plot.series.every((s) => s.x.every(Number.isInteger))), y: axisOf(plot.log_y, plot.range_y, plot.bottom_edge) },
    },
  });
};

let charts = [];
const drawAll = () => {
  for (const chart of charts) chart.destroy();
  Chart.defaults.font.size = sized(12);
  charts = plots.map(chartOf);
  document.documentElement.dataset.plots = charts.length;
};
drawAll();
document.addEventListener("scheme", drawAll);

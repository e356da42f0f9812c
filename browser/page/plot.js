// Plots of a material in SVG, in the colours of the page.

const kWidth = 380, kHeight = 260, kMostCurves = 8;
const kRgb = ["var(--c1)", "var(--c2)", "var(--c0)"];
const colourOf = (k, count) => count === 3 ? kRgb[k] : `var(--c${k % 8})`;

const keysOf = (names, colours) => make("ul", { className: "keys" }, ...names.map((name, k) =>
  make("li", {}, make("i", { style: "background: " + colours[k] }), name)));

const figureOf = (title, sentence, shapes, keys, note) => make("figure", {},
  make("p", { className: "title" }, title),
  inSvg("svg", { viewBox: `0 0 ${kWidth} ${kHeight}`, role: "img", "aria-label": sentence }, ...shapes),
  keys, make("figcaption", {}, note));

// Returns the path through the points; a point of null is a gap.
const pathOf = (points) => points.map((point, k) => point === null ? ""
  : (k > 0 && points[k - 1] !== null ? "L" : "M") + point[0].toFixed(1) + " " + point[1].toFixed(1)).join("");

// Sentences on the values of curves that the plot cannot show as they are.
const unknownOf = (values) => {
  const unknown = values.filter((value) => value === null).length;
  return (unknown > 0 ? `; ${unknown} of ${values.length} values are unknown, which are gaps` : "")
    + (values.some((value) => value !== null && value < 0) ? "; values below 0 are drawn at 0" : "");
};

const label = (x, y, anchor, text) => inSvg("text", { x, y, "text-anchor": anchor }, text);

// The albedo of each channel against the angle of incidence.
const albedoPlot = ({ theta, albedo, above_one: aboveOne }, channels) => {
  const left = 42, right = kWidth - 12, top = 12, bottom = kHeight - 34;
  const all = albedo.flat(), known = all.filter((value) => value !== null);
  const most = Math.max(...known), end = Math.max(1, Math.ceil(10 * most) / 10);
  const x = (degrees) => left + (right - left) * degrees / 90, y = (value) => bottom - (bottom - top) * Math.max(value, 0) / end;
  const step = Math.max(1, Math.ceil(albedo.length / kMostCurves)), drawn = albedo.map((_, k) => k).filter((k) => k % step === 0);
  const colours = drawn.map((_, place) => colourOf(place, drawn.length));
  const curve = (k) => theta.map((t, row) => albedo[k][row] === null ? null : [x(t), y(albedo[k][row])]);
  const values = [0, end / 2, end];
  const shapes = [
    ...values.flatMap((v) => [inSvg("line", { class: "grid", x1: left, x2: right, y1: y(v), y2: y(v) }), label(left - 6, y(v) + 4, "end", shown(v, 3))]),
    ...[0, 30, 60, 90].map((t) => label(x(t), bottom + 17, "middle", t + "\u00b0")),
    ...(end > 1 ? [inSvg("line", { class: "ray", stroke: "var(--bad)", x1: left, x2: right, y1: y(1), y2: y(1) })] : []),
    ...drawn.map((k, place) => inSvg("path", { class: "curve", stroke: colours[place], d: pathOf(curve(k)) })),
  ];
  const energy = aboveOne ? "; above 1, the material reflects more light than arrives" : "";
  const note = `albedo against the angle of incidence${energy}${unknownOf(all)}`
    + (step > 1 ? `; ${drawn.length} of ${albedo.length} channels are drawn` : "");
  const range = known.length > 0 ? `Albedo from ${shown(Math.min(...known), 3)} to ${shown(most, 3)}` : "No albedo is known";
  return figureOf("Albedo", `${range} at ${theta.length} angles of incidence from ${theta[0]} to ${theta[theta.length - 1]} degrees${energy}.`,
    shapes, keysOf(albedo.length > 1 ? drawn.map((k) => channels[k] ?? "channel " + (k + 1)) : [], colours), note);
};

const kAnchors = ["end", "middle", "start"];  // of labels on the left, in the middle, on the right

// The lobe f cos in the plane of incidence, for some angles of incidence: light from the left, theta_o negative on the side of the light.
const lobePlot = ({ lobes }) => {
  const cx = kWidth / 2, cy = kHeight - 34, reach = Math.min(cx - 44, cy - 24);
  const all = lobes.flatMap((lobe) => lobe.f_cos), most = Math.max(...all.filter((value) => value !== null), Number.MIN_VALUE);
  const at = (degrees, radius) => [cx + reach * radius * Math.sin(degrees * Math.PI / 180), cy - reach * radius * Math.cos(degrees * Math.PI / 180)];
  const ring = (radius) => inSvg("path", { class: "grid", d: pathOf([...Array(61).keys()].map((k) => at(3 * k - 90, radius))) });
  const colours = lobes.map((_, k) => colourOf(k, 8));
  const curve = ({ theta_o: angles, f_cos: values }) => angles.map((t, k) => values[k] === null ? null : at(t, Math.cbrt(Math.max(values[k], 0) / most)));
  const ray = (degrees, k) => {
    const [x, y] = at(-degrees, 1.03);
    return inSvg("line", { class: "ray", stroke: colours[k], x1: x, y1: y, x2: cx, y2: cy });
  };
  const shapes = [ring(0.5), ring(1), inSvg("line", { class: "grid", x1: cx - reach, x2: cx + reach, y1: cy, y2: cy }),
    inSvg("line", { class: "grid", x1: cx, x2: cx, y1: cy, y2: cy - reach }),
    ...[-90, -45, 0, 45, 90].map((t) => label(...at(t, 1.05), kAnchors[Math.sign(t) + 1], Math.abs(t) + "\u00b0")),
    ...lobes.map((lobe, k) => ray(lobe.theta_i, k)), ...lobes.map((lobe, k) => inSvg("path", { class: "curve", stroke: colours[k], d: pathOf(curve(lobe)) }))];
  const peakOf = (values) => values.length > 0 ? shown(Math.max(...values), 3) : "unknown";
  const peaks = lobes.map((lobe) => `${peakOf(lobe.f_cos.filter((value) => value !== null))} at ${lobe.theta_i} degrees`).join(", ");
  return figureOf("Lobe in the plane of incidence", `Largest value of f cos: ${peaks} of incidence.`, shapes,
    keysOf(lobes.map((lobe) => `incidence ${lobe.theta_i}\u00b0`), colours),
    `f cos \u03b8, mean of the channels${unknownOf(all)}; the radius is the cube root, and the outer circle is ${shown(most, 3)} 1/sr; dashed: the light`);
};

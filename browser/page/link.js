// A permanent link holds a material in the fragment of the address: #form=ward&kd=0.2,0.1,0.3&alpha=0.1 for a form of the catalogue,
// and #material=..., its JSON in base64url, for any other material.

class LinkFault extends Error {}

const toBase64Url = (text) => btoa(Array.from(new TextEncoder().encode(text), (byte) => String.fromCharCode(byte)).join(""))
  .replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");

const fromBase64Url = (text) =>
  new TextDecoder("utf-8", { fatal: true }).decode(Uint8Array.from(atob(text.replace(/-/g, "+").replace(/_/g, "/")), (c) => c.charCodeAt(0)));

// `chosen` is {form, parameters} or {material}.
const fragmentOf = ({ form, parameters, material }) => material
  ? "#material=" + toBase64Url(JSON.stringify(material))
  : "#form=" + encodeURIComponent(form) + Object.entries(parameters).map(([symbol, values]) =>
    "&" + encodeURIComponent(symbol) + "=" + values.map((v) => shown(v, 17)).join(",")).join("");

const valuesIn = (text, { symbol, low, high, colour }) => {
  const values = text.split(",").map((word) => word.trim() === "" ? NaN : Number(word));
  if (!values.every(Number.isFinite)) throw new LinkFault(`${symbol}=${text} is not a number.`);
  const beyond = values.find((v) => v < low || v > high);
  if (beyond !== undefined) throw new LinkFault(`${symbol} is ${beyond}, and the sliders of this page reach from ${low} to ${high}.`);
  if (values.length !== 1 && !(colour && values.length === 3))
    throw new LinkFault(`${symbol} has ${values.length} values, and ${colour ? "1 or 3 are" : "1 is"} possible.`);
  return values;
};

const catalogueIn = (words, forms) => {
  const { form: name, ...given } = words;
  const form = forms.find((f) => f.name === name);
  if (!form) throw new LinkFault(`The program has no form "${name}".`);
  const symbols = form.parameters.map((p) => p.symbol);
  const unknown = Object.keys(given).find((symbol) => !symbols.includes(symbol));
  if (unknown) throw new LinkFault(`The form ${name} has no parameter "${unknown}"; its parameters are ${symbols.join(", ")}.`);
  const parameters = Object.fromEntries(form.parameters.map((p) =>
    [p.symbol, p.symbol in given ? valuesIn(given[p.symbol], p) : [p.default]]));
  return { form: name, parameters };
};

// Returns the material of a fragment, null if it holds no material; throws a LinkFault with a sentence.
const chosenIn = (fragment, forms) => {
  if (!fragment.includes("=")) return null;
  const given = [...new URLSearchParams(fragment.slice(1))], words = Object.fromEntries(given);
  const twice = given.find(([key], k) => given.findIndex(([other]) => other === key) !== k);
  if (twice) throw new LinkFault(`The link states ${twice[0]} twice.`);
  if ("form" in words) return catalogueIn(words, forms);
  if (!("material" in words)) throw new LinkFault("A link begins with #form= or #material=, in small letters.");
  try {
    const material = JSON.parse(fromBase64Url(words.material));
    if (material && typeof material === "object" && !Array.isArray(material)) return { material };
  } catch {}
  throw new LinkFault("The text after #material= is not a material; the link may have been cut off.");
};

// Returns the parameters of a fitted material if the catalogue's sliders can show it, else the material without the report of its fit.
const chosenOf = ({ fit, ...material }, forms) => {
  const form = forms.find((f) => f.name === material.form);
  const { format, version, form: name, channels = [], weights = {}, shape = {}, tangent_phi: phi = 0, ...more } = material;
  const given = { ...weights, ...shape };
  const listed = (value) => Array.isArray(value) ? value : [value];
  // The sliders give names to the channels, so other names would be lost.
  const fits = form && phi === 0 && Object.keys(more).length === 0 && ["fr", "r,g,b"].includes(channels.join(","))
    && Object.keys(given).length === form.parameters.length
    && form.parameters.every(({ symbol, low, high, colour }) => symbol in given && listed(given[symbol]).every((v) => v >= low && v <= high)
      && (listed(given[symbol]).length === 1 || (colour && listed(given[symbol]).length === 3)));
  return fits ? { form: name, parameters: Object.fromEntries(form.parameters.map(({ symbol }) => [symbol, listed(given[symbol])])) } : { material };
};

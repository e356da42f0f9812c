// Short names for the elements of the page.
const byId = (id) => document.getElementById(id);

// Returns a new element with these properties, or attributes if the element has no such property, and children.
const make = (tag, settings = {}, ...children) => {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(settings))
    if (name in element) element[name] = value;
    else element.setAttribute(name, value);
  element.append(...children);
  return element;
};

const inSvg = (tag, attributes = {}, ...children) => {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, value);
  element.append(...children);
  return element;
};

// Returns a number for people: at most `digits` digits, no exponent between 1e-4 and 1e6.
const shown = (value, digits = 4) => String(Number(value.toPrecision(digits)));

const percent = (share) => share === null ? "unknown" : share < 1e-11 ? "below 1e-9 %" : shown(100 * share, 2) + " %";

const size = (bytes) => bytes < 1000 ? bytes + " bytes" : bytes < 1e6 ? shown(bytes / 1e3, 3) + " kB" : shown(bytes / 1e6, 3) + " MB";

// Returns a button that copies a text. Browsers allow copying only on pages of secure addresses and of files.
const copyButton = (what, text) => {
  const button = make("button", { type: "button" }, "Copy " + what);
  button.addEventListener("click", async () => {
    try {
      await navigator.clipboard.writeText(text());
      button.textContent = "Copied";
    } catch {
      button.textContent = "The browser does not allow copying: select the text";
    }
    setTimeout(() => { button.textContent = "Copy " + what; }, 2000);
  });
  return button;
};

// Returns a list of links that download these files: [{name, blob, url}]. A saved file has `prefix` before its name, so that the files
// of two tables can lie in one folder.
const downloads = (files, prefix = "") => make("ul", { className: "downloads", "aria-label": "Downloads" }, ...files.map(({ name, label, blob, url }) =>
  make("li", {}, make("a", { href: url, download: prefix + name, "data-file": name }, label ?? name), " ",
    make("span", { className: "note" }, size(blob.size)))));

const kTypes = { html: "text/html", json: "application/json", gltf: "model/gltf+json", png: "image/png", glsl: "text/plain" };

// Returns files of the program with addresses for downloads.
const withAddresses = (files) => files.map(({ name, data }) => {
  const blob = new Blob([data], { type: kTypes[name.split(".").pop()] ?? "application/octet-stream" });
  return { name, blob, url: URL.createObjectURL(blob) };
});

const forget = (files) => files.forEach(({ url }) => URL.revokeObjectURL(url));

// Finished results: one shown, or two next to each other.

// Runs within the frame of a report, which has no files and no address of its own: links to files ask this page for a download. The
// page learns the height of the whole report, which it needs for printing.
const joinPage = () => {
  addEventListener("click", (event) => {
    const link = event.target.closest("a[href]"), address = link?.getAttribute("href");
    if (!link || link.download || /^[a-z]+:/.test(address)) return;
    event.preventDefault();
    if (address.startsWith("#")) document.getElementById(address.slice(1))?.scrollIntoView();
    else parent.postMessage({ download: decodeURIComponent(address) }, "*");
  });
  const tellHeight = () => parent.postMessage({ height: document.body.scrollHeight }, "*");
  addEventListener("load", tellHeight);  // a frame that is not on the screen observes no size
  new ResizeObserver(tellHeight).observe(document.body);
};

const inOrder = (files) => {
  const first = ["index.html", "material.json", "material.glsl", "fit.json"], place = ({ name }) => first.includes(name) ? first.indexOf(name) : first.length;
  return [...files].sort((a, b) => place(a) - place(b))
    .map((file) => file.name === "index.html" ? { ...file, label: "report (index.html)" } : file);
};

// ward_ for ward.csv
const prefixOf = ({ name }) => name.replace(/\.[^.]*$/, "") + "_";

const reportOf = ({ files }) => files.find(({ name }) => name === "index.html");

class Results {
  finished = [];

  // `inCatalogue(material)` shows a fitted material in the catalogue, `linkOf(material)` returns its permanent link, `asGltf(material)`
  // asks the program for a glTF file.
  constructor(inCatalogue, linkOf, asGltf) {
    Object.assign(this, { inCatalogue, linkOf, asGltf });
    for (const select of [byId("left"), byId("right")]) select.addEventListener("change", () => this.show());
    addEventListener("message", ({ source, data }) => {
      const frame = [...document.querySelectorAll(".pane iframe")].find(({ contentWindow }) => contentWindow === source);
      if (typeof data?.download === "string")
        frame?.closest(".pane").querySelector(`.downloads a[data-file="${CSS.escape(data.download)}"]`)?.click();
      if (data?.height > 0) frame?.style.setProperty("--height", `${Math.ceil(data.height)}px`);
    });
  }

  add(entry) {
    this.finished.push(entry);
    this.list(entry);
  }

  removed(entry) {
    forget(entry.files);
    this.finished.splice(this.finished.indexOf(entry), 1);
    const left = this.finished[byId("left").value] === entry ? this.finished[0] : this.left;
    this.list(left === entry ? this.finished[0] : left);
  }

  // Shows why a table has no result, and no older result.
  refuse(entry, sentence) {
    this.list(undefined);
    const { name } = entry;
    byId("refusal").textContent = sentence.includes(name) ? sentence : `${name}: ${sentence}`;
    byId("refusal").className = "verdict bad";
    byId("no_result").hidden = true;
  }

  // Writes the lists of results, and selects one result for the left side.
  list(left) {
    const right = left && this.right !== left && this.finished.includes(this.right) ? this.right : undefined;
    const options = () => this.finished.map((entry, k) => make("option", { value: String(k) }, `${k + 1}. ${entry.name}`));
    byId("left").replaceChildren(make("option", { value: "" }, "no result"), ...options());
    byId("right").replaceChildren(make("option", { value: "" }, "no other result"), ...options());
    byId("left").value = left ? String(this.finished.indexOf(left)) : "";
    byId("right").value = right ? String(this.finished.indexOf(right)) : "";
    byId("choice").hidden = this.finished.length === 0;
    byId("choice").querySelector("label + label").hidden = this.finished.length < 2;
    this.show();
  }

  show() {
    const entryOf = (select) => select.value === "" ? undefined : this.finished[Number(select.value)];
    if (byId("right").value === byId("left").value) byId("right").value = "";
    this.left = entryOf(byId("left"));
    this.right = entryOf(byId("right"));
    byId("refusal").textContent = byId("refusal").className = "";
    byId("no_result").hidden = Boolean(this.left || this.right);
    document.body.classList.toggle("two", Boolean(this.left && this.right));
    // A pane that stays is not moved, because a frame that is moved is loaded again.
    const panes = byId("panes"), wanted = [this.left, this.right].filter(Boolean);
    for (const pane of [...panes.children]) if (!wanted.includes(pane.entry)) pane.remove();
    wanted.forEach((entry, k) => {
      if (panes.children[k]?.entry !== entry) panes.insertBefore(this.pane(entry), panes.children[k] ?? null);
    });
  }

  pane(entry) {
    const { name, row, command, assumptions, files } = entry;
    const facts = [["form", row.form], ["measurements", row.rows.toLocaleString("en")], ["median error", percent(row.median_relative_error)],
      ["left-out error", percent(row.cross_validated_error)]];
    if (row.within_tolerance !== null) facts.push([`tolerance of ${shown(100 * row.tolerance, 6)} %`, row.within_tolerance ? "kept" : "exceeded"]);
    const remarks = [...assumptions, ...row.warnings];
    const number = this.finished.indexOf(entry) + 1;
    const frame = make("iframe", { title: `Report on ${name}`, sandbox: "allow-scripts allow-popups allow-modals allow-downloads" });
    const pane = make("article", { className: "pane", "aria-label": `Result ${number}: ${name}` },
      make("h3", {}, name),
      make("p", { className: "verdict " + row.mark }, row.statement),
      make("ul", { className: "facts" }, ...facts.map(([label, value]) => make("li", {}, label + " ", make("b", {}, value)))),
      ...(remarks.length ? [make("ul", { className: "remarks" }, ...remarks.map((text) => make("li", { className: "warn" }, text)))] : []),
      ...(row.next ? [make("p", { className: "next" }, "Next: ", row.next)] : []),
      make("p", { className: "note" }, "The same study with the installed program:"),
      make("div", { className: "command" }, make("pre", {}, command), copyButton("command", () => command)),
      downloads(inOrder(files), prefixOf(entry)));
    pane.entry = entry;
    this.addMaterial(pane, entry);
    pane.append(frame);
    this.load(frame, reportOf(entry));
    return pane;
  }

  async load(frame, report) {
    if (!report) return frame.remove();
    frame.srcdoc = await report.blob.text() + "<script>(" + joinPage + ")()<\/script>";
  }

  async addMaterial(pane, entry) {
    const file = entry.files.find(({ name }) => name === "material.json");
    if (!file) return;
    const material = JSON.parse(await file.blob.text());
    const button = make("button", { type: "button" }, "Show the material in the catalogue");
    button.addEventListener("click", () => this.inCatalogue(material));
    pane.querySelector("iframe").before(make("p", { className: "fields" }, button, this.gltfButton(entry, material),
      copyButton("permanent link of the material", () => this.linkOf(material))));
  }

  // The file is written when it is asked for, because a refit may take seconds. The loss is shown next to the file.
  gltfButton(entry, material) {
    const button = make("button", { type: "button" }, "Write material.gltf");
    button.addEventListener("click", async () => {
      const note = make("p", { className: "note", role: "status" }, "material.gltf is being written.");
      button.closest("p").after(note);
      button.disabled = true;
      const { answer, files, cancelled } = await this.asGltf(material);
      if (cancelled || answer.error) {
        note.textContent = answer?.error ?? "Cancelled.";
        button.disabled = false;
        return;
      }
      const made = withAddresses(files);
      entry.files.push(...made);
      note.replaceChildren(`glTF holds the material as: ${answer.statement}. The same with the installed program: ${answer.command}`, downloads(made, prefixOf(entry)));
    });
    return button;
  }
}

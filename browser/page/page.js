// Puts the parts of the page together. browser/build.py joins this file with the files that it needs.

const addDrops = (queue) => {
  const carriesFiles = (event) => [...event.dataTransfer?.types ?? []].includes("Files");
  addEventListener("dragover", (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    document.body.classList.add("dragging");  // reports let the files through to this page
  });
  addEventListener("dragleave", (event) => {
    if (!event.relatedTarget) document.body.classList.remove("dragging");
  });
  addEventListener("drop", (event) => {
    if (!carriesFiles(event)) return;
    event.preventDefault();
    document.body.classList.remove("dragging");
    queue.add(event.dataTransfer.files);
  });
};

const addChooser = (queue) => byId("files").addEventListener("change", () => {
  queue.add([...byId("files").files]);
  byId("files").value = "";  // so that the same file can be chosen again
});

const addExamples = async (queue) => {
  for (const button of document.querySelectorAll("button[data-example]")) {
    const name = button.dataset.example, text = await part(name);
    button.addEventListener("click", () => queue.add([new File([text], name, { type: "text/csv" })]));
    button.disabled = false;
  }
};

const addChoices = ({ version, forms, metrics }) => {
  byId("version").textContent = `brdf ${version}, compiled to WebAssembly. The commands on this page are for the installed program of the same version.`;
  if (byId("forms").childElementCount) return;
  for (const { name, title, fittable } of forms) {
    if (!fittable) continue;
    const box = make("input", { type: "checkbox", value: name });
    box.addEventListener("change", () => { document.querySelector('input[value="chosen"]').checked = true; });
    byId("forms").append(make("label", { title: title ?? "" }, box, " " + name));
  }
  for (const name of metrics) byId("metric").append(make("option", { value: name }, name));
};

const main = async () => {
  const engine = new Engine(), catalogue = new Catalogue(engine);
  const results = new Results((material) => catalogue.showFitted(material),
    (material) => catalogue.addressOf(chosenOf(material, catalogue.forms)),
    (material) => engine.ask({ request: { do: "export", material } }).answered);
  const queue = new Queue(engine, results);
  engine.changed = () => {
    queue.refresh();
    catalogue.refresh();
  };
  engine.loaded = (about) => {
    addChoices(about);
    queue.say("The program is ready.", null);
    catalogue.fill(about.forms);
  };
  engine.failed = (sentence) => {
    queue.say(sentence, null);
    byId("progress").hidden = true;
    byId("notice").className = "verdict bad";
    byId("notice").textContent = sentence;
  };
  addDrops(queue);
  addChooser(queue);
  try {
    await Promise.all([engine.load(), addExamples(queue)]);
  } catch (fault) {
    return engine.fail("The program could not be loaded: " + fault.message);
  }
  // From here on the browser refuses every request of the page and of its workers.
  document.head.append(make("meta", { httpEquiv: "Content-Security-Policy", content: "connect-src 'none'" }));
  engine.start();
};

main();

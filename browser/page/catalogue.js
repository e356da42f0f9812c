// The catalogue: a form with sliders, or a fitted material, with its plots and files.

const kSteps = 1000, kPause = 120;  // steps of a slider; milliseconds without a change before the program is asked

// A range of two decades and more has equal steps of the logarithm.
const scaleOf = ({ low, high }) => {
  const logarithmic = low > 0 && high / low >= 100;
  return {
    value: (step) => step <= 0 ? low : step >= kSteps ? high : logarithmic ? low * (high / low) ** (step / kSteps) : low + (high - low) * step / kSteps,
    step: (value) => Math.round(kSteps * (logarithmic ? Math.log(value / low) / Math.log(high / low) : (value - low) / (high - low))),
  };
};

// The family stands beside the name unless both are the same words.
const titleOf = ({ name, title }) => title && name !== title.toLowerCase().replace(/\W/g, "_") ? `${name} (${title})` : name;

class Catalogue {
  chosen = null;  // {form, parameters} or {material}
  files = [];

  constructor(engine) {
    this.engine = engine;
    byId("form").addEventListener("change", () => this.choose(this.start(byId("form").value)));
    byId("channels").addEventListener("change", () => this.split(byId("channels").checked));
    addEventListener("hashchange", () => this.follow());
  }

  // Called with the forms of the program, when it is loaded first.
  fill(forms) {
    if (this.forms) return;
    this.forms = forms;
    byId("form").replaceChildren(make("option", { value: "", hidden: true }, "a fitted material"),
      ...forms.map((form) => make("option", { value: form.name }, titleOf(form))));
    byId("form").disabled = false;
    this.choose(this.start((forms.find((form) => form.name === "ward") ?? forms[0]).name), false);
    this.follow();
  }

  start(name) {
    const form = this.forms.find((f) => f.name === name), count = byId("channels").checked ? 3 : 1;
    return { form: name, parameters: Object.fromEntries(form.parameters.map((p) => [p.symbol, Array(p.colour ? count : 1).fill(p.default)])) };
  }

  // Shows the material of the address.
  follow() {
    byId("link_fault").textContent = byId("link_fault").className = "";
    if (location.hash === this.written) return;
    try {
      const chosen = chosenIn(location.hash, this.forms);
      if (!chosen) return;
      this.written = location.hash;
      this.choose(chosen, false);
      byId("catalogue_title").scrollIntoView();
    } catch (fault) {
      byId("link_fault").className = "verdict bad";
      byId("link_fault").textContent = "The link holds no material that can be shown. " + (fault instanceof LinkFault ? fault.message : "Its text is damaged.");
      byId("catalogue_title").scrollIntoView();
    }
  }

  addressOf(chosen) {
    return location.href.replace(/#.*/s, "") + fragmentOf(chosen);
  }

  showFitted(material) {
    this.choose(chosenOf(material, this.forms));
    byId("catalogue_title").scrollIntoView();
  }

  choose(chosen, write = true) {
    this.chosen = chosen;
    byId("form").value = chosen.form ?? "";
    byId("channels").disabled = !chosen.form;
    if (chosen.form) {
      byId("channels").checked = Object.values(chosen.parameters).some((values) => values.length === 3);
      this.split(byId("channels").checked, false);
    }
    this.drawSliders();
    this.changed(write, 0);
  }

  // Gives each parameter that may have a colour one value, or three.
  split(three, redraw = true) {
    const form = this.forms.find((f) => f.name === this.chosen.form);
    for (const { symbol, colour } of form.parameters) {
      const values = this.chosen.parameters[symbol];
      if (colour && three !== (values.length === 3)) this.chosen.parameters[symbol] = three ? Array(3).fill(values[0]) : [values[0]];
    }
    if (!redraw) return;
    this.drawSliders();
    this.changed(true, 0);
  }

  drawSliders() {
    const { form: name, parameters, material } = this.chosen;
    if (material)
      return byId("sliders").replaceChildren(make("p", { className: "note" },
        `The material is ${material.form ?? "a sum of forms"}, as it was fitted. Choose a form to change parameters.`));
    const form = this.forms.find((f) => f.name === name);
    byId("sliders").replaceChildren(...form.parameters.flatMap((parameter) =>
      parameters[parameter.symbol].map((_, k, values) => this.slider(parameter, k, values.length === 3 ? ", " + ["red", "green", "blue"][k] : ""))));
  }

  slider(parameter, k, channel) {
    const { symbol, name, low, high } = parameter, scale = scaleOf(parameter), values = this.chosen.parameters[symbol];
    const title = (name && name !== symbol ? `${symbol}: ${name}` : symbol) + channel;
    const range = make("input", { type: "range", min: "0", max: String(kSteps), "aria-label": title + ", slider" });
    const number = make("input", { type: "number", min: String(low), max: String(high), step: "any", id: `${symbol}_${k}` });
    const put = (value, from) => {
      values[k] = value;
      if (from !== range) range.value = String(scale.step(value));
      if (from !== number) number.value = shown(value);
      range.setAttribute("aria-valuetext", shown(value));
    };
    put(values[k], null);
    range.addEventListener("input", () => {
      const rounded = Number(shown(scale.value(Number(range.value))));
      put(Math.min(Math.max(rounded, low), high), range);
      this.accept(number);
      this.changed(true);
    });
    number.addEventListener("input", () => {
      const value = number.value === "" ? NaN : Number(number.value), good = value >= low && value <= high;
      this.accept(number, good ? "" : `${symbol} is a number from ${low} to ${high}.`);
      if (!good) return number.reportValidity();
      put(value, number);
      this.changed(true);
    });
    number.addEventListener("blur", () => {  // the field shows the value of the plots again
      if (!number.validity.valid) put(values[k], null);
      this.accept(number);
    });
    return make("div", { className: "parameter" }, make("label", { htmlFor: number.id }, title), range, number);
  }

  // Marks the number of a field as possible, or as impossible for the reason in `fault`.
  accept(number, fault = "") {
    number.setAttribute("aria-invalid", String(fault !== ""));
    number.setCustomValidity(fault);
  }

  // The chosen material differs: the plots are old until the program answers.
  changed(write, pause = kPause) {
    byId("plots").classList.add("old");
    clearTimeout(this.timer);
    if (this.question && this.question !== this.engine.current) this.engine.cancel(this.question);
    this.timer = setTimeout(() => this.ask(write), pause);
  }

  async ask(write) {
    if (write) {
      byId("link_fault").textContent = byId("link_fault").className = "";
      this.written = fragmentOf(this.chosen);
      history.replaceState(null, "", this.written);
    }
    const question = this.engine.ask({ request: { do: "material", ...this.chosen } });
    this.question = question;
    this.refresh();
    const { answer, files, cancelled } = await question.answered;
    if (question !== this.question) return;  // a later question is on its way
    this.question = null;
    if (!cancelled) this.show(answer, files);
  }

  // States why the plots wait.
  refresh() {
    if (!this.question) return;
    const waits = this.engine.ready && this.engine.current?.file;
    byId("material_state").textContent = waits ? "The plots wait until the tables of the queue are fitted." : "";
  }

  show(answer, files) {
    forget(this.files);
    this.files = withAddresses(answer.error ? [] : files);
    byId("plots").classList.remove("old");
    byId("material_state").textContent = answer.error ?? "";
    byId("material_state").className = answer.error ? "verdict bad" : "";
    if (answer.error) return [byId("plots"), byId("material_files")].forEach((part) => part.replaceChildren());
    const channels = this.chosen.material?.channels ?? (answer.albedo.length === 3 ? ["red", "green", "blue"] : []);
    byId("plots").replaceChildren(albedoPlot(answer, channels), lobePlot(answer));
    const address = this.addressOf(this.chosen);
    const link = make("input", { type: "text", readOnly: true, value: address, id: "permanent_link" });
    byId("material_files").replaceChildren(downloads(this.files),
      make("div", { className: "command" }, make("pre", {}, answer.command), copyButton("command", () => answer.command)),
      make("p", { className: "note" }, make("label", { htmlFor: link.id }, "Permanent link of this material")),
      make("div", { className: "command" }, link, copyButton("link", () => address)));
  }
}

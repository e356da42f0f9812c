// The tables that were dropped or chosen, each with its state, and the settings for tables to come.

// Returns {form, metric, tolerance}, or a sentence if the settings cannot be used.
const settings = () => {
  const models = document.querySelector('input[name="models"]:checked').value;
  const chosen = [...document.querySelectorAll("#forms input:checked")].map((box) => box.value);
  if (models === "chosen" && chosen.length === 0) return "No form is chosen: check at least one form, or choose all or auto.";
  const field = byId("tolerance"), share = field.value === "" ? null : Number(field.value) / 100;
  if (field.validity.badInput || (share !== null && !(share > 0 && share <= 1)))
    return "The tolerance is not a number above 0 and up to 100 %: correct the number, or leave the field empty.";
  return { form: models === "chosen" ? chosen.join(",") : models, metric: byId("metric").value, tolerance: share };
};

const stateOf = ({ mark, within_tolerance: within }) =>
  mark === "bad" ? "fitted, not usable" : within === false ? "fitted, outside the tolerance" : "fitted";

class Queue {
  entries = [];

  // `results` has the functions shows, refuse and removed.
  constructor(engine, results) {
    Object.assign(this, { engine, results });
    byId("cancel").addEventListener("click", () => {
      if (!engine.current?.file) return;
      engine.cancel(engine.current);
      byId("files").focus();  // the button is hidden now
    });
  }

  add(files) {
    const chosen = settings();
    byId("notice").textContent = typeof chosen === "string" ? chosen : "";
    if (typeof chosen === "string") return;
    for (const file of files) this.study(file, chosen);
  }

  async study(file, chosen) {
    const entry = { name: file.name, item: make("li"), state: make("span", { className: "state" }) };
    entry.button = make("button", { type: "button" });
    entry.button.addEventListener("click", () => this.remove(entry));
    entry.item.append(make("strong", {}, file.name), entry.state, entry.button);
    this.entries.push(entry);
    byId("queue").append(entry.item);
    this.mark(entry, "waits", "Remove");
    entry.question = this.engine.ask({
      request: { do: "study", table: file.name, ...chosen }, file,
      begun: () => {
        this.mark(entry, "is being fitted", "");
        this.say(file.name + ": the table is being read.", null);
      },
      progress: ({ text, share }) => this.say(`${file.name}: ${text}`, share),
      fitted: (sentence) => entry.item.append(make("p", { className: "first" }, `${sentence}. The report is being made.`)),
    });
    this.refresh();
    const outcome = await entry.question.answered;
    entry.question = null;
    this.finish(entry, outcome);
  }

  finish(entry, { answer, files, cancelled }) {
    entry.item.querySelector(".first")?.remove();
    if (cancelled) this.mark(entry, "cancelled", "Remove");
    else if (answer.error) {
      this.mark(entry, "refused", "Remove");
      entry.item.append(make("p", { className: "refused" }, answer.error));
      this.results.refuse(entry, answer.error);
    } else {
      const { row, command, assumptions } = answer;
      Object.assign(entry, { row, command, assumptions, files: withAddresses(files) });
      this.mark(entry, stateOf(row), "Remove");
      this.results.add(entry);
    }
    if (!this.entries.some((e) => e.question)) this.say(`${entry.name}: ${entry.state.textContent}.`, null);
    this.refresh();
  }

  remove(entry) {
    if (entry.question) this.engine.cancel(entry.question);
    this.entries.splice(this.entries.indexOf(entry), 1);
    entry.item.remove();
    if (entry.files) this.results.removed(entry);
    byId("files").focus();
    this.refresh();
  }

  mark(entry, state, button) {
    entry.state.textContent = state;
    entry.button.textContent = button;
    entry.button.hidden = !button;
    entry.button.setAttribute("aria-label", `${button} ${entry.name}`);
  }

  // The state is announced when its text changes; the bar moves silently.
  say(text, share) {
    if (byId("status").textContent !== text) byId("status").textContent = text;
    if (share !== null && share >= 0) byId("progress").value = share;
    else byId("progress").removeAttribute("value");
  }

  refresh() {
    const current = this.engine.current;
    byId("cancel").hidden = !current?.file;
    byId("progress").hidden = this.engine.ready && !current;
    byId("no_queue").hidden = this.entries.length > 0;
  }
}

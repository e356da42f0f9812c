// The program as the page sees it: questions wait in a line, and a worker answers one after another. A question with a file is a
// fit and goes first. A cancelled fit ends its worker, and a new worker goes on with the line.

// Returns a part of the program: from this page if it is one file, else from the server.
const part = async (name) => {
  const held = document.querySelector(`script[data-part="${name}"]`);
  if (held) return held.textContent;
  const answer = await fetch(name);
  if (!answer.ok) throw new Error(`${name}: the server answers ${answer.status}`);
  return name.endsWith(".wasm") ? answer.arrayBuffer() : answer.text();
};

class Engine {
  line = [];
  current = null;
  ready = false;
  changed = () => {};  // called when a question begins or ends
  loaded = () => {};   // called with the answer to "about" at each start
  failed = () => {};   // called with a sentence if the program cannot be started
  fault = "";          // the sentence, from then on the answer to every question

  async load() {
    const [glue, worker, wasm] = await Promise.all(["brdf.js", "worker.js", "brdf.wasm"].map(part));
    // A worker from a blob is subject to the policy of the page; a worker from an address is not.
    this.code = URL.createObjectURL(new Blob([glue, "\n", worker], { type: "text/javascript" }));
    this.wasm = wasm;
  }

  start() {
    this.ready = false;
    this.worker = new Worker(this.code);
    this.worker.onmessage = ({ data }) => this.heard(data);
    this.worker.onerror = (event) => {
      event.preventDefault();
      this.heard({ stopped: event.message || "the worker could not be started" });
    };
    this.worker.postMessage({ start: this.wasm });
  }

  heard({ ready, progress, fitted, answer, files, stopped }) {
    if (progress) return this.current?.progress?.(progress);
    if (fitted) return this.current?.fitted?.(fitted);
    if (ready) {
      this.ready = true;
      this.loaded(ready);
    } else if (answer) this.end({ answer, files });
    else if (this.ready) {  // the program stopped during a question: its memory cannot be trusted
      const sentence = "The program stopped (" + stopped + "). A new one has been started; a smaller table or fewer forms need less memory.";
      this.restart({ answer: { error: sentence }, files: [] });
    } else {
      this.worker.terminate();
      this.fail("The program could not be started: " + stopped);
    }
    this.next();
  }

  fail(sentence) {
    this.fault = sentence;
    this.failed(sentence);
    for (const { resolve } of this.line.splice(0)) resolve({ answer: { error: sentence }, files: [] });
  }

  end(result) {
    const { resolve } = this.current;
    this.current = null;
    resolve(result);
  }

  restart(result) {
    this.worker.terminate();
    this.end(result);
    this.start();
  }

  next() {
    if (this.ready && !this.current && this.line.length) {
      const fit = this.line.findIndex((question) => question.file);
      [this.current] = this.line.splice(Math.max(fit, 0), 1);
      const { request, file } = this.current;
      this.current.begun?.();
      this.worker.postMessage({ request, file });
    }
    this.changed();
  }

  // Returns a question {request, file, begun, progress, fitted} with `answered`, a promise of {answer, files} or {cancelled: true}.
  ask(question) {
    question.answered = new Promise((resolve) => { question.resolve = resolve; });
    if (this.fault) question.resolve({ answer: { error: this.fault }, files: [] });
    else this.line.push(question);
    this.next();
    return question;
  }

  cancel(question) {
    if (question === this.current) this.restart({ cancelled: true });
    else if (this.line.includes(question)) {
      this.line.splice(this.line.indexOf(question), 1);
      question.resolve({ cancelled: true });
    }
    this.changed();
  }
}

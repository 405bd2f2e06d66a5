// A worker that answers one question at a time. Of those that wait only the newest is asked.

export class Asker {
  #worker;
  #asked; // none while the worker starts
  #busy = true;
  #next;
  #pace;
  #sent = 0;
  #timer = 0;

  /// A worker of the text `source`. `started` gets its first message, `failed` what a worker says that cannot go on. Between
  /// two questions are at least `pace` [ms].
  constructor(source, { started, failed, pace = 0 }) {
    this.#pace = pace;
    this.#worker = new Worker(URL.createObjectURL(new Blob([source], { type: "text/javascript" })));
    const next = () => { // before the answer is drawn: the worker goes on meanwhile
      const asked = this.#asked;
      [this.#asked, this.#busy] = [undefined, false];
      this.#send();
      return asked;
    };
    this.#worker.onerror = ({ message }) => {
      next();
      failed(message ?? "a worker did not start");
    };
    this.#worker.onmessage = ({ data }) => {
      if (data.failed) return failed(data.failed); // it has not started, and never will
      const asked = next();
      if ("answer" in data) asked?.use(data.answer, asked.question);
      else started(data);
      return undefined;
    };
  }

  /// What is said before any question.
  say(message) { this.#worker.postMessage(message); }

  ask(question, use) {
    this.#next = { question, use };
    if (!this.#busy) this.#send();
  }

  #send() {
    if (!this.#next) return;
    const wait = this.#sent + this.#pace - performance.now();
    if (wait > 0) {
      this.#timer ||= setTimeout(() => {
        this.#timer = 0;
        if (!this.#busy) this.#send();
      }, wait);
      return;
    }
    this.#sent = performance.now();
    [this.#asked, this.#next, this.#busy] = [this.#next, undefined, true];
    this.#worker.postMessage(this.#asked.question);
  }
}

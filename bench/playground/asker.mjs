// A worker that answers one question at a time. Of those that wait only the newest is asked.

export class Asker {
  #worker;
  #asked; // none while the worker starts
  #busy = true;
  #next;
  #pace;
  #sent = 0;
  #timer = 0;

  /// A worker of the text `source`. `started` gets its first message, `failed` a sentence. Between two questions are at
  /// least `pace` [ms].
  constructor(source, { started, failed, pace = 0 }) {
    this.#pace = pace;
    this.#worker = new Worker(URL.createObjectURL(new Blob([source], { type: "text/javascript" })));
    this.#worker.onerror = ({ message }) => failed(`This browser cannot run the page: ${message ?? "a worker did not start"}.`);
    this.#worker.onmessage = ({ data }) => {
      const asked = this.#asked;
      this.#asked = undefined;
      this.#busy = false;
      this.#send(); // before the answer is drawn: the worker goes on meanwhile
      if (asked) asked.use(data.answer, asked.question);
      else started(data);
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

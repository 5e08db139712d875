/* The page's one interpreter: starts a worker at the first wish, passes cells to it, and says what it is doing. */
"use strict";
(function () {
  const base = new URL("./", document.currentScript.src).href;
  const seconds = (since) => ((performance.now() - since) / 1000).toFixed(1);
  const megabytes = (bytes) => (bytes / 1e6).toFixed(1);

  class Python {
    constructor(report) {
      this.report = report; // {state, text, detail, share}: state is idle, fetching, starting, ready, running, failed
      this.count = 0;
      this.waiting = new Map();
      this.forget();
    }

    forget() {
      this.worker?.terminate();
      this.worker = null;
      this.running = null;
      clearInterval(this.clock);
      for (const { stopped } of this.waiting.values()) stopped();
      this.waiting.clear();
    }

    /* Ends whatever runs; its variables are gone with it. */
    stop() {
      this.forget();
      this.say("idle", "Stopped. Python starts anew at the next run; what the cells had defined is gone.");
    }

    say(state, text, detail = "", share = null) {
      this.state = state;
      this.report({ state, text, detail, share });
    }

    fail(message) {
      this.forget();
      this.say("failed", `Python cannot run here: ${message}.`);
    }

    start() {
      if (this.worker) return;
      if (typeof WebAssembly !== "object") throw this.fail("this browser has no WebAssembly, or it is switched off");
      try {
        this.worker = new Worker(base + "worker.js");
      } catch (error) {
        const file = location.protocol === "file:";
        throw this.fail(file ? "a page opened as a file may not start it; serve the folder, as its READ_ME says"
                             : `the browser refuses to start a worker (${error.message})`);
      }
      this.began = performance.now();
      this.ready = false;
      this.say("fetching", "Fetching Python.");
      this.worker.onmessage = ({ data }) => this.heard(data);
      this.worker.onerror = (event) => {
        event.preventDefault();
        if (this.state !== "failed") this.fail(event.message || "its program could not be fetched; is the connection lost?");
      };
      this.worker.onmessageerror = () => this.fail("a message was garbled");
    }

    heard(data) {
      if (data.progress) {
        const { bytes, total, name } = data.progress;
        const detail = `${megabytes(bytes)} of ${megabytes(total)} MB, ${seconds(this.began)} s (${name})`;
        this.say("fetching", "Fetching Python.", detail, bytes / total);
      } else if (data.starting) {
        this.tick("starting", "Starting Python.");
      } else if (data.ready) {
        this.ready = true;
        this.readyAfter = data.ready.seconds;
        this.say("ready", "Python is ready.", `${megabytes(data.ready.bytes)} MB in ${data.ready.seconds.toFixed(1)} s`);
        this.tick("running", this.running ? `Running ${this.running}.` : "");
      } else if (data.fetching !== undefined) {
        const what = data.fetching && `Fetching ${data.fetching.name.replace(".zip", "")}, ${megabytes(data.fetching.bytes)} MB.`;
        this.tick(what ? "fetching" : "running", what || `Running ${this.running}.`);
      } else if (data.shown !== undefined) {
        this.waiting.get(`run ${data.shown}`)?.shown(data.kind, data.text);
      } else if (data.done !== undefined) {
        this.answered(`run ${data.done}`, data);
      } else if (data.frame !== undefined) {
        this.answered(`frame ${data.frame}`, data);
      } else if (data.fatal) {
        this.fail(data.fatal);
      }
    }

    answered(key, data) {
      const asked = this.waiting.get(key);
      this.waiting.delete(key);
      asked?.done(data);
    }

    tick(state, text) {
      clearInterval(this.clock);
      if (!text) return;
      const since = performance.now();
      this.say(state, text);
      this.clock = setInterval(() => this.say(state, text, `${seconds(since)} s`), 200);
    }

    /* Run code; `shown(kind, text)` hears what it prints, up to `limit` characters if that is said; `after`: what is to
       come after it, in words. Resolves to {ok, milliseconds}, or {stopped: true}. */
    run(cell, code, shown, { limit, after = "" } = {}) {
      this.start();
      const number = ++this.count;
      this.running = cell + after;
      if (this.ready) this.tick("running", `Running ${this.running}.`);
      return new Promise((resolve) => {
        this.waiting.set(`run ${number}`, { shown, stopped: () => resolve({ stopped: true }), done: (data) => {
          clearInterval(this.clock);
          this.running = null;
          this.say("ready", data.ok ? `Ran ${cell}.` : `Failed: ${cell}.`, `${(data.milliseconds / 1000).toFixed(2)} s`);
          resolve(data);
        } });
        this.worker.postMessage({ run: number, cell, code, limit });
      });
    }

    /* A frame of a figure that a cell has made: {drawn: [value, svg, note]}, {failed} or {stopped}. */
    frame(key, position) {
      const number = ++this.count;
      return new Promise((resolve) => {
        this.waiting.set(`frame ${number}`, { stopped: () => resolve({ stopped: true }), done: resolve });
        this.worker.postMessage({ frame: number, key, position });
      });
    }
  }

  window.Live.Python = Python;
})();

/* Makes the cells tagged `live` of a page editable and runnable. Nothing is fetched before a reader asks for it. */
"use strict";
(function () {
  const { editor, escaped, highlighted, Python } = window.Live;
  const KEYS = "Shift and Enter runs the cell. Once you have typed, Tab indents; Escape, then Tab, leaves the box.";
  const make = (tag, properties = {}, ...children) => {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
  };

  const notebook = () => {
    const link = document.querySelector('a[href$=".ipynb"]');
    return link ? make("a", { href: link.href, download: "", textContent: "the notebook" }) : "the notebook";
  };

  /* What the reader typed, kept in this browser only. */
  const kept = {
    broken: false,
    key: (text) => `${location.pathname} ${[...text].reduce((h, c) => (Math.imul(h, 31) + c.codePointAt(0)) | 0, 7)}`,
    read(original) { try { return localStorage.getItem(this.key(original)); } catch { return null; } },
    write(original, text) {
      try {
        if (text === original) localStorage.removeItem(this.key(original));
        else localStorage.setItem(this.key(original), text);
        return true;
      } catch { return false; }
    },
    forget() {
      try {
        Object.keys(localStorage).filter((k) => k.startsWith(location.pathname + " ")).forEach((k) => localStorage.removeItem(k));
      } catch { /* nothing was kept */ }
    },
  };

  class Cell {
    constructor(element, number, page) {
      Object.assign(this, { element, number, page, name: `cell ${number}`, ok: false });
      this.optional = element.matches(".tag_exercise, .tag_solution");
      // A result that is folded away stays so: its fold moves with it.
      this.still = element.querySelector("details.below-input") ?? element.querySelector(".cell_output");
      this.output = make("div", { className: "cell_output live-output", hidden: true });
      this.output.setAttribute("aria-label", `Result of ${this.name}`);
      this.output.setAttribute("role", "group");
      this.code = editor(element.querySelector(".cell_input pre"), `Python code, ${this.name}`, () => this.edited(), () => page.runTo(this));
      const button = (text, label, action) => {
        const made = make("button", { type: "button", textContent: text, onclick: action });
        made.setAttribute("aria-label", `${label}: ${this.name}`);
        return made;
      };
      const figure = element.querySelector("figure.sweep");
      this.runButton = figure ? button("Compute live", "Compute this figure live", () => page.runTo(this))
                              : button("Run", "Run", () => page.runTo(this));
      this.runButton.title = page.hint;
      this.resetButton = button("Reset", "Reset to the book's text and result", () => this.reset());
      this.bar = make("div", { className: "live-bar" }, this.runButton);
      this.bar.append(this.resetButton, make("span", { className: "live-name", textContent: this.name }));
      // Folded code stands below its result, its buttons in the same line; code that is open above it.
      this.fold = element.querySelector("details.above-input");
      if (this.fold) element.prepend(this.output);
      element.append(this.bar);
      if (!this.fold) element.append(this.output, ...(this.still ? [this.still] : []), ...element.querySelectorAll(":scope > figure"));
      this.code.text = kept.read(this.code.original) ?? this.code.original;
      this.state();
    }

    state() {
      const changed = this.code.text !== this.code.original;
      this.resetButton.disabled = !changed && this.output.hidden;
      this.element.classList.toggle("live-edited", changed);
    }

    edited() {
      this.code.mark(null);
      if (!kept.write(this.code.original, this.code.text) && !kept.broken) {
        kept.broken = true;
        this.page.say("This browser keeps nothing for this page (its storage is full or forbidden): copy what you want to keep.");
      }
      this.state();
    }

    reset() {
      this.code.text = this.code.original;
      this.edited();
      this.output.replaceChildren();
      this.output.hidden = true;
      if (this.still) this.still.hidden = false;
      this.state();
    }

    /* It ran, and its text is the one that ran: what stands below can count on it. */
    get current() { return this.ok && this.ran === this.code.text; }

    /* `after`, if other cells are to follow: how many, in words. */
    async run(after = "") {
      // What was made from another text of this cell, further down, is out of date.
      if (!this.optional && this.ran !== this.code.text) this.page.cells.slice(this.number).forEach((c) => { c.ok = false; });
      this.ran = this.code.text;
      this.output.replaceChildren();
      this.output.hidden = false;
      if (this.still) this.still.hidden = true;
      this.code.mark(null);
      this.element.classList.add("live-running");
      this.state();
      let result;
      try {
        result = await this.page.python.run(this.name, this.code.text, (kind, text) => this.show(kind, text), { after });
      } catch {
        result = { stopped: true };
      }
      this.element.classList.remove("live-running");
      this.ok = Boolean(result.ok);
      if (result.stopped) this.show("stderr", "Stopped.\n");
      if (this.ok) this.judged();
      this.element.dataset.ran = result.stopped ? "stopped" : result.ok ? "ok" : "failed";
      this.state();
      return this.ok;
    }

    show(kind, text) {
      ({ value: this.showValue, error: this.showError }[kind] || this.showText).call(this, text, kind);
    }

    showText(text, kind) {
      const last = this.output.lastElementChild;
      if (last?.dataset.kind === kind) last.append(text);
      else this.put(make("pre", { className: `live-text live-${kind}`, textContent: text }), kind);
    }

    showError(text) {
      const { line, name, text: message } = JSON.parse(text);
      this.put(make("pre", { className: "live-text live-error", textContent: message }), "error").setAttribute("role", "alert");
      this.code.mark(line);
      if (this.fold) this.fold.open = true; // the line that it points to is to be seen
      if (name === "NameError" && this.optional) this.advise("This cell runs by itself: import or define here what it uses.");
      else if (line && name !== "Rejected") this.advise("The error is in the marked line. Change it and run again, or Reset to the book's text.");
    }

    /* What to do about an error. */
    advise(...words) {
      this.put(make("p", { className: "live-advice" }, ...words), "hint");
    }

    /* A result that only confirms, as the book's does, is as green; an exercise that was accepted is remembered. */
    judged() {
      const said = this.output.textContent;
      this.output.classList.toggle("confirmed", this.still?.querySelector(".confirmed pre")?.textContent === said);
      const accepted = this.element.matches(".tag_exercise") && said.match(/^Exercise ([\w.]+) accepted:/m);
      if (accepted) window.Live.exercises.accepted(accepted[1]);
    }

    showValue(text) {
      const value = JSON.parse(text);
      const before = this.output.childElementCount;
      if (value.slider) this.put(this.slider(JSON.parse(value.slider)), "slider");
      else if (value.html || value.svg) this.put(make("div", { innerHTML: value.html || value.svg }), "html");
      else if (value.latex || value.markdown) this.typeset(value);
      else this.showText(value.text + "\n", "value");
      if (this.output.childElementCount > before) this.output.lastElementChild.dataset.text = value.text + "\n";
    }

    typeset({ latex, markdown }) {
      const [, python] = (markdown || "").match(/^```python\n([\s\S]*?)```\s*$/) || [];
      const block = python === undefined ? make("div", { className: "live-math", textContent: latex || markdown })
        : make("div", { className: "highlight", innerHTML: `<pre>${highlighted(python)}</pre>` });
      this.put(block, "text");
      if (python !== undefined) return;
      block.textContent = block.textContent.replace(/^\$\$?(?:\\displaystyle)?([\s\S]*?)\$?\$$/, "\\[$1\\]");
      window.MathJax?.typesetPromise?.([block]);
    }

    put(element, kind) {
      element.dataset.kind = kind;
      this.output.append(element);
      return element;
    }

    /* A figure with its slider; each move asks Python for a frame, one at a time. */
    slider({ key, label, last, start, steps, names, button, frame }) {
      const id = `live-slider-${this.number}`;
      const range = names.length // a menu of them, in place of the slider
        ? make("select", { id, autocomplete: "off" }, ...names.map((name, i) => make("option", { value: i, textContent: name })))
        : make("input", { type: "range", id, min: 0, max: last, step: 1 / steps, autocomplete: "off" });
      range.value = start;
      const shown = make("output", { hidden: names.length > 0 }), picture = make("div"), note = make("p", { className: "sweep-note" });
      note.setAttribute("aria-live", "polite");
      const draw = ([value, svg, text]) => {
        shown.textContent = value;
        if (!names.length) range.setAttribute("aria-valuetext", value);
        picture.innerHTML = svg;
        note.textContent = text;
      };
      let busy = false, wanted = null;
      const move = async () => {
        wanted = range.value;
        if (busy) return;
        busy = true;
        while (wanted !== null) {
          const position = Number(wanted);
          wanted = null;
          const answer = this.page.python.worker ? await this.page.python.frame(key, position) : { stopped: true };
          if (answer.drawn) draw(answer.drawn);
          else note.textContent = answer.failed ? `The figure failed: ${answer.failed}` : "Python was stopped: compute the figure again.";
        }
        busy = false;
        figure.dataset.position = range.value;
      };
      range.addEventListener("input", move);
      draw(frame);
      const bar = make("div", { className: "sweep-bar" }, make("label", { htmlFor: id, textContent: label }), range, shown);
      bar.insertAdjacentHTML("beforeend", button);
      const figure = make("figure", { className: "sweep live" }, bar, picture, note);
      return figure;
    }
  }

  class Page {
    constructor(elements) {
      this.hint = "Runs in this page. The first run fetches Python, about @MEGABYTES@ MB; nothing you type leaves this browser.";
      this.python = new Python((news) => this.news(news));
      this.queue = Promise.resolve();
      this.turn = 0; // Stop and Restart begin another: what was waiting in this one is not run
      this.panel = this.makePanel();
      this.cells = elements.map((element, i) => new Cell(element, i + 1, this));
      document.body.append(make("p", { id: "live-keys", hidden: true, textContent: KEYS }), this.panel);
    }

    /* A pill that says what Python is doing; what can be done about it is behind it, but for Stop. */
    makePanel() {
      this.status = make("span", { className: "live-status" });
      this.status.setAttribute("role", "status");
      this.detail = make("span", { className: "live-detail" });
      this.advice = make("p", { hidden: true });
      this.progress = make("progress", { max: 1, hidden: true });
      this.progress.setAttribute("aria-label", "Part fetched");
      this.stopButton = make("button", { type: "button", textContent: "Stop", hidden: true, onclick: () => this.stop() });
      const button = (textContent, title, onclick) => make("button", { type: "button", textContent, title, onclick });
      this.more = make("details", {},
        make("summary", {}, this.status, " ", this.detail),
        make("p", {},
          button("Restart", "Python forgets what the cells defined; your text stays", () => this.restart()),
          button("Forget my text", "Every cell of this page becomes the book's again", () => this.forget()),
          button("Forget my ticks", "No exercise of the book counts as accepted any more", () => this.untick()),
          button("Hide", "Until the next cell runs", () => { this.panel.hidden = true; })));
      const panel = make("section", { className: "live-panel", hidden: true }, this.more, this.stopButton, this.progress, this.advice);
      panel.setAttribute("aria-label", "Python in this page");
      return panel;
    }

    say(text) {
      this.panel.hidden = false;
      if (this.status.textContent !== text) this.status.textContent = text;
    }

    news({ state, text, detail, share }) {
      this.say(text);
      this.detail.textContent = detail;
      this.progress.hidden = share === null;
      if (share !== null) this.progress.value = share;
      this.panel.dataset.state = state;
      if (state === "idle" || state === "failed") this.nothingRan();
      this.stopButton.hidden = ["idle", "ready", "failed"].includes(state);
      this.advice.hidden = state !== "failed";
      if (state === "failed") this.offerNotebook();
    }

    offerNotebook() {
      this.advice.replaceChildren("The page can be read as before. You can download ", notebook(), " and run it with Jupyter, or try again.");
    }

    /* Run a cell after those above it that it needs: all that have not run as they stand. An exercise needs none. */
    runTo(cell) {
      const turn = this.turn;
      this.queue = this.queue.then(() => (turn === this.turn ? this.runNow(cell) : null));
      return this.queue;
    }

    async runNow(cell) {
      const needed = () => (cell.optional ? [] : this.cells.filter((c) => c.number < cell.number && !c.optional && !c.current));
      for (let left = needed(); left.length; left = needed()) {
        const other = left[0];
        if (await other.run(`, then ${left.length} more`)) continue;
        const link = make("a", { href: "#", textContent: other.name });
        link.onclick = (event) => {
          event.preventDefault();
          other.element.scrollIntoView({ block: "center" });
          other.runButton.focus({ preventScroll: true });
        };
        cell.output.replaceChildren();
        cell.output.hidden = false;
        cell.advise(`${cell.name} was not run: `, link, ", which it needs, did not end well.");
        cell.element.dataset.ran = "failed";
        return;
      }
      await cell.run();
    }

    stop() {
      this.turn += 1;
      this.python.stop();
    }

    nothingRan() {
      this.cells.forEach((c) => { c.ok = false; });
    }

    restart() {
      this.turn += 1;
      this.python.forget();
      this.nothingRan();
      this.python.start();
    }

    forget() {
      kept.forget();
      this.cells.forEach((c) => c.reset());
      this.say("Forgotten: every cell is the book's again.");
    }

    untick() {
      window.Live.exercises.forget();
      this.say("Forgotten: no exercise counts as accepted.");
    }
  }

  window.addEventListener("DOMContentLoaded", () => {
    for (const cell of document.querySelectorAll("div.cell.tag_not-live"))
      cell.append(make("p", { className: "live-not" }, "This cell needs what a browser does not have: run it in ", notebook(), "."));
    const elements = [...document.querySelectorAll("div.cell.tag_live")].filter((e) => e.querySelector(".cell_input pre"));
    if (elements.length) window.Live.page = new Page(elements);
  });
})();

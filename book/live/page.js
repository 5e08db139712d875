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
      this.code = editor(element.querySelector(".cell_input pre"), `Python code, ${this.name}`, () => this.edited(), () => this.run());
      const button = (text, label, action) => {
        const made = make("button", { type: "button", textContent: text, onclick: action });
        made.setAttribute("aria-label", `${label}: ${this.name}`);
        return made;
      };
      const figure = element.querySelector("figure.sweep");
      this.runButton = figure ? button("Compute live", "Run all above and compute this figure live", () => page.runTo(this))
                              : button("Run", "Run", () => this.run());
      this.runButton.title = page.hint;
      this.resetButton = button("Reset", "Reset to the book's text and result", () => this.reset());
      this.bar = make("div", { className: "live-bar" }, this.runButton);
      if (!figure && number > 1) this.bar.append(button("Run all above", "Run all above and", () => page.runTo(this)));
      this.bar.append(this.resetButton, make("span", { className: "live-name", textContent: this.name }));
      // Folded code stands below its result, its buttons in the same line; code that is open above it.
      this.fold = element.querySelector("details.above-input");
      if (this.fold) element.prepend(this.output);
      element.append(this.bar);
      if (!this.fold) element.append(this.output, ...(this.still ? [this.still] : []));
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

    async run() {
      this.output.replaceChildren();
      this.output.hidden = false;
      if (this.still) this.still.hidden = true;
      this.code.mark(null);
      this.element.classList.add("live-running");
      this.state();
      let result;
      try {
        result = await this.page.python.run(this.name, this.code.text, (kind, text) => this.show(kind, text));
      } catch {
        result = { stopped: true };
      }
      this.element.classList.remove("live-running");
      this.ok = Boolean(result.ok);
      if (result.stopped) this.show("stderr", "Stopped.\n");
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
      if (name === "NameError" && this.page.cells.some((c) => c.number < this.number && !c.ok && !c.optional))
        this.put(make("p", { textContent: "Cells above this one have not been run: try “Run all above”." }), "hint");
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
    slider({ key, label, last, start, steps, names, frame }) {
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
      const figure = make("figure", { className: "sweep live" }, bar, picture, note);
      return figure;
    }
  }

  class Page {
    constructor(elements) {
      this.hint = "Runs in this page. The first run fetches Python, about @MEGABYTES@ MB; nothing you type leaves this browser.";
      this.python = new Python((news) => this.news(news));
      this.panel = this.makePanel();
      this.cells = elements.map((element, i) => new Cell(element, i + 1, this));
      document.body.append(make("p", { id: "live-keys", hidden: true, textContent: KEYS }), this.panel);
    }

    makePanel() {
      this.status = make("span", { className: "live-status" });
      this.status.setAttribute("role", "status");
      this.detail = make("span", { className: "live-detail" });
      this.progress = make("progress", { max: 1, hidden: true });
      this.progress.setAttribute("aria-label", "Part fetched");
      this.stopButton = make("button", { type: "button", textContent: "Stop", onclick: () => this.python.stop() });
      const restart = make("button", { type: "button", textContent: "Restart", title: "Python forgets what the cells defined; your text stays", onclick: () => this.restart() });
      const forget = make("button", { type: "button", textContent: "Forget my text", title: "Every cell of this page becomes the book's again", onclick: () => this.forget() });
      const hide = make("button", { type: "button", textContent: "Hide", onclick: () => { this.panel.hidden = true; } });
      const panel = make("section", { className: "live-panel", hidden: true },
        make("p", {}, this.status, " ", this.detail), this.progress, make("p", {}, this.stopButton, restart, forget, hide));
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
      this.stopButton.disabled = ["idle", "ready", "failed"].includes(state);
      if (state === "failed") this.offerNotebook();
    }

    offerNotebook() {
      const link = document.querySelector('a[href$=".ipynb"]');
      if (!link) return;
      this.detail.replaceChildren("The page can be read as before. You can ",
        make("a", { href: link.href, textContent: "download the notebook", download: "" }), " and run it with Jupyter, or try again.");
    }

    async runTo(cell) {
      for (const other of this.cells) {
        if (other.number > cell.number) return;
        if (other !== cell && (other.optional || (other.ok && !other.element.classList.contains("live-edited")))) continue;
        if (!(await other.run())) {
          if (other === cell) return;
          cell.element.dataset.ran = "failed";
          this.say(`${other.name} failed, so ${cell.name} was not run.`);
          return;
        }
      }
    }

    nothingRan() {
      this.cells.forEach((c) => { c.ok = false; });
    }

    restart() {
      this.python.forget();
      this.nothingRan();
      this.python.start();
    }

    forget() {
      kept.forget();
      this.cells.forEach((c) => c.reset());
      this.say("Forgotten: every cell is the book's again.");
    }
  }

  window.addEventListener("DOMContentLoaded", () => {
    const elements = [...document.querySelectorAll("div.cell.tag_live")].filter((e) => e.querySelector(".cell_input pre"));
    if (elements.length) window.Live.page = new Page(elements);
  });
})();

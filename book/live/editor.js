/* A box to edit Python in: a textarea over the highlighted text, so that keyboard, phone and screen reader have their own. */
"use strict";
(function () {
  const WORDS = {
    k: "and as assert async await break class continue def del elif else except finally for global if in is lambda nonlocal not or pass raise return try while with yield",
    kn: "from import",
    kc: "True False None",
    nb: "abs all any bool dict enumerate float int isinstance len list map max min print range repr round set sorted str sum tuple type zip",
  };
  const KIND = Object.fromEntries(Object.entries(WORDS).flatMap(([kind, words]) => words.split(" ").map((w) => [w, kind])));
  const TOKEN = new RegExp([
    /(?<c1>#[^\n]*)/, /(?<s1>[rbfRBF]{0,2}(?:"""[\s\S]*?(?:"""|(?![\s\S]))|'''[\s\S]*?(?:'''|(?![\s\S]))|"(?:\\.|[^"\\\n])*"?|'(?:\\.|[^'\\\n])*'?))/,
    /(?<nd>^[ \t]*@[\w.]+)/, /(?<mi>\b(?:\d[\d_]*\.?\d*|\.\d+)(?:[eE][+-]?\d+)?j?\b\.?)/, /(?<word>[^\W\d]\w*)/, /(?<o>[-+*/%@&|^~<>=!]+)/,
  ].map((r) => r.source).join("|"), "gmu");
  const escaped = (text) => text.replace(/&/g, "&amp;").replace(/</g, "&lt;").replace(/>/g, "&gt;");

  function highlighted(code) {
    let made = "", at = 0, before = "";
    for (const found of code.matchAll(TOKEN)) {
      made += escaped(code.slice(at, found.index));
      const groups = Object.entries(found.groups).find(([, text]) => text !== undefined);
      let kind = groups ? groups[0] : "";
      if (kind === "word") kind = code[found.index - 1] === "." ? "n" : KIND[found[0]] || (before === "def" ? "nf" : before === "class" ? "nc" : "n");
      made += `<span class="${kind}">${escaped(found[0])}</span>`;
      before = found[0];
      at = found.index + found[0].length;
    }
    return made + escaped(code.slice(at)) + "\n";
  }

  /* Replaces the code of a cell by an editor; `name` is what a screen reader calls it. */
  function editor(pre, name, changed, run) {
    const original = pre.textContent.replace(/\n$/, "");
    const box = document.createElement("div"), area = document.createElement("textarea");
    box.className = "live-editor";
    area.value = original;
    area.spellcheck = false;
    for (const [key, value] of [["autocapitalize", "off"], ["autocomplete", "off"], ["autocorrect", "off"], ["aria-label", name]])
      area.setAttribute(key, value);
    area.setAttribute("aria-describedby", "live-keys");
    pre.parentNode.insertBefore(box, pre);
    box.append(pre, area);
    pre.removeAttribute("tabindex");

    let typing = false; // Tab indents only once something was typed here: a reader who passes through is not caught
    const draw = () => {
      pre.innerHTML = highlighted(area.value);
      area.rows = area.value.split("\n").length;
    };
    const put = (text) => document.execCommand("insertText", false, text); // keeps the browser's own undo
    const line = () => area.value.slice(area.value.lastIndexOf("\n", area.selectionStart - 1) + 1, area.selectionStart);
    area.addEventListener("input", () => { typing = true; draw(); changed(); });
    area.addEventListener("focus", () => { typing = false; });
    area.addEventListener("keydown", (event) => {
      if (event.key === "Enter" && (event.shiftKey || event.ctrlKey || event.metaKey)) {
        event.preventDefault();
        run();
      } else if (event.key === "Enter") {
        event.preventDefault();
        put("\n" + line().match(/^\s*/)[0] + (/:\s*(#.*)?$/.test(line()) ? "    " : ""));
      } else if (event.key === "Tab" && typing && !event.shiftKey) {
        event.preventDefault();
        put(" ".repeat(4 - (line().length % 4)));
      } else if (event.key === "Escape") {
        typing = false;
      } else if (event.key === "Backspace" && area.selectionStart === area.selectionEnd && /^(    )+$/.test(line())) {
        event.preventDefault();
        area.setSelectionRange(area.selectionStart - 4, area.selectionStart);
        document.execCommand("delete");
      }
    });
    return {
      original,
      get text() { return area.value; },
      set text(value) { area.value = value; draw(); },
      mark(number) { // point to the line of an error
        box.querySelector(".live-line")?.remove();
        area.removeAttribute("aria-invalid");
        if (!number) return;
        const place = document.createElement("div");
        place.className = "live-line";
        place.style.setProperty("--line", number - 1);
        box.append(place);
        area.setAttribute("aria-invalid", "true");
      },
    };
  }

  window.Live = { ...window.Live, editor, escaped, highlighted };
})();

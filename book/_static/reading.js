/* "Show all code": one button in the header unfolds the code of every cell, and is remembered in this browser. Long
   listings fade out; the button below one shows it whole, as do a click into it and typing. */
"use strict";
window.addEventListener("DOMContentLoaded", () => {
  const KEY = "show all code", LONG = 30; // lines; below that, what a fade saves is not worth a click
  const make = (text) => Object.assign(document.createElement("button"), { type: "button", textContent: text });

  function fading(box) {
    const lines = box.querySelector("pre").textContent.trimEnd().split("\n").length;
    if (lines < LONG) return [];
    const button = make(""), show = (whole) => {
      box.classList.toggle("faded", !whole);
      button.setAttribute("aria-expanded", String(whole));
      button.textContent = whole ? "fewer lines" : `all ${lines} lines`;
    };
    button.className = "all-lines";
    button.addEventListener("click", () => show(box.classList.contains("faded")));
    box.addEventListener("click", () => show(true));
    box.addEventListener("keydown", ({ key }) => { if (key !== "Tab" && key !== "Shift") show(true); });
    box.after(button);
    show(false);
    return [show];
  }

  const folds = [...document.querySelectorAll("details.hide.above-input")].map((fold) => (open) => { fold.open = open; });
  const code = "div.cell:not(.tag_exercise, .tag_solution) > .cell_input:has(pre)";
  const fades = [...document.querySelectorAll(code)].flatMap(fading);
  // A link at each heading, and a button to copy each cell, are for the mouse: with the keyboard the contents lead to the
  // same places, and a box's text is selected and copied as anywhere. (The buttons are made when all is loaded.)
  const passed = () => document.querySelectorAll("a.headerlink, div.cell .copybtn").forEach((e) => { e.tabIndex = -1; });
  passed();
  window.addEventListener("load", () => setTimeout(passed));
  // A formula is no stop for the keyboard, but one that is wider than its place scrolls, and must be reached for that.
  const wide = new ResizeObserver((all) => all.forEach(({ target }) => {
    if (target.scrollWidth > target.clientWidth) target.tabIndex = 0;
    else target.removeAttribute("tabindex");
  }));
  window.addEventListener("load", () => window.MathJax?.startup?.promise?.then(() => {
    document.querySelectorAll('.bd-article mjx-container[display="true"]').forEach((formula) => wide.observe(formula));
  }));
  // The theme's link to the main content leads to the buttons above it; this one past them, to the text.
  const article = document.querySelector(".bd-article"), skip = document.querySelector("#pst-skip-link a");
  if (article && skip) {
    article.id ||= "text";
    skip.hash = article.id;
  }
  const header = document.querySelector(".article-header-buttons");
  if (!folds.length && !fades.length || !header) return;
  const button = make("");
  button.className = "btn btn-sm all-code";
  button.title = "Show all code";
  button.setAttribute("aria-label", button.title);
  button.innerHTML = '<i class="fa-solid fa-code fa-lg" aria-hidden="true"></i>';
  const show = (all) => {
    button.setAttribute("aria-pressed", String(all));
    for (const open of [...folds, ...fades]) open(all);
  };
  const kept = () => { try { return localStorage.getItem(KEY) === "yes"; } catch { return false; } };
  button.addEventListener("click", () => {
    const all = button.getAttribute("aria-pressed") !== "true";
    try {
      if (all) localStorage.setItem(KEY, "yes");
      else localStorage.removeItem(KEY);
    } catch { /* this browser keeps nothing: the button works on this page alone */ }
    show(all);
  });
  header.prepend(button);
  button.setAttribute("aria-pressed", "false");
  if (kept()) show(true);
});

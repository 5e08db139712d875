/* "Show all code": one button in the header unfolds the code of every cell, and is remembered in this browser. */
"use strict";
window.addEventListener("DOMContentLoaded", () => {
  const KEY = "show all code", folds = [...document.querySelectorAll("details.hide.above-input")];
  const header = document.querySelector(".article-header-buttons");
  if (!folds.length || !header) return;
  const button = document.createElement("button");
  button.type = "button";
  button.className = "btn btn-sm all-code";
  button.title = "Show all code";
  button.setAttribute("aria-label", button.title);
  button.innerHTML = '<i class="fa-solid fa-code fa-lg" aria-hidden="true"></i>';
  const show = (all) => {
    button.setAttribute("aria-pressed", String(all));
    folds.forEach((fold) => { fold.open = all; });
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

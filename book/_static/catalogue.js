/* The catalogue of Jacobians: a field above its contents shows only the models whose name or module contains what is
   typed there, and says how many they are. Without it, or when it is empty, all are there. */
"use strict";
window.addEventListener("DOMContentLoaded", () => {
  const page = document.querySelector("#catalogue-of-jacobians"), contents = page?.querySelector("#contents");
  if (!contents) return;
  const OUT = "filtered-out", plain = (text) => text.toLowerCase().replace(/[-_]/g, "");

  // A section is a heading with what follows it, up to the next one.
  const sections = [...page.querySelectorAll(".cell_output > h3[id]")].map((heading) => {
    const parts = [heading];
    for (let e = heading.nextElementSibling; e && !e.matches("h3"); e = e.nextElementSibling) parts.push(e);
    const chain = Boolean(heading.closest("#common-chains")), title = heading.textContent;
    return { id: heading.id, parts, chain, name: plain(chain ? title.split(" ")[0] : title) }; // ahmPnt
  });
  const models = sections.filter(({ chain }) => !chain), chains = sections.filter(({ chain }) => chain);

  // In the contents each link is a word of its own: what is left of a list has no separators without their words.
  const links = [...contents.querySelectorAll("li a")].map((a) => ({ a, id: a.hash.slice(1) }));
  for (const { a } of links) if (a.nextSibling?.textContent.trim() === "·") a.nextSibling.textContent = " ";
  const items = [...contents.querySelectorAll("li")].reverse(); // the inner ones first

  const field = Object.assign(document.createElement("input"), { type: "search", id: "catalogue-filter" });
  field.autocomplete = "off";
  field.spellcheck = false;
  const label = Object.assign(document.createElement("label"), { htmlFor: field.id });
  label.textContent = "Show only models whose name or module contains";
  const count = document.createElement("output");
  count.setAttribute("for", field.id);
  count.setAttribute("aria-live", "polite");
  const box = document.createElement("div");
  box.className = "catalogue-filter";
  box.setAttribute("role", "search");
  box.append(label, field, count);
  contents.before(box);

  const out = (element, gone) => element?.classList.toggle(OUT, gone);
  function show() {
    const words = plain(field.value).split(/\s+/).filter(Boolean), filtered = words.length > 0;
    const shown = new Set(sections.filter(({ name }) => words.every((word) => name.includes(word))));
    for (const section of sections) section.parts.forEach((part) => out(part, !shown.has(section)));
    const ids = new Set([...shown].map(({ id }) => id));
    for (const { a, id } of links) out(a, !ids.has(id));
    for (const item of items) out(item, !item.querySelector(`a:not(.${OUT})`));
    // What is about all of them stands aside: how to read them, their code, and the chains when none is left.
    out(page.querySelector("#common-chains"), !chains.some((chain) => shown.has(chain)));
    out(page.querySelector("#reading-an-entry"), filtered);
    for (const cell of page.querySelectorAll("#models > .cell:not(:has(> .cell_output > h3))")) out(cell, filtered);
    const number = models.filter((model) => shown.has(model)).length;
    count.textContent = filtered ? `${number} of ${models.length} models` : `${models.length} models`;
  }

  const clear = () => { field.value = ""; show(); };
  field.addEventListener("input", show);
  field.addEventListener("keydown", ({ key }) => { if (key === "Escape") clear(); });

  // A link into what is left out shows all again.
  function shownAgain(hash) {
    const target = document.getElementById(hash.slice(1));
    if (!target?.closest(`.${OUT}`)) return;
    clear();
    target.scrollIntoView();
  }
  window.addEventListener("hashchange", () => shownAgain(location.hash));
  document.addEventListener("click", ({ target }) => {
    const link = target.closest?.("a[href*='#']");
    if (link && link.href.split("#")[0] === location.href.split("#")[0]) shownAgain(link.hash);
  });
  // Browsers that restore a form's values on "back" need the rest to follow.
  window.addEventListener("pageshow", () => { show(); shownAgain(location.hash); });
  show();
});

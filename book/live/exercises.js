/* Which exercises were accepted: remembered in this browser alone, and ticked beside the chapters of the side bar. */
"use strict";
(function () {
  const KEY = "exercises accepted", CHECK = /\bcheck\("((\w+)\.\d+)"/;
  const chapters = { // by the name of their page: how many exercises it has, and which were accepted
    read() {
      try {
        return JSON.parse(localStorage.getItem(KEY)) ?? {};
      } catch { return {}; } // nothing was kept, or nothing can be
    },
    write(all) {
      try { localStorage.setItem(KEY, JSON.stringify(all)); } catch { /* the ticks last as long as the page */ }
    },
  };
  let all = chapters.read();

  function tick() {
    for (const link of document.querySelectorAll(".bd-links a[href]")) {
      const name = new URL(link.href).pathname.match(/(\w+)\.html$/)?.[1], { of = 0, accepted = [] } = all[name] ?? {};
      link.querySelector(".ticks")?.remove();
      if (!accepted.length) continue;
      const mark = document.createElement("span");
      mark.className = "ticks";
      mark.textContent = `\u2713 ${accepted.length} of ${of}`;
      mark.title = `${accepted.length} of ${of} exercises accepted`;
      link.append(" ", mark);
    }
    for (const cell of document.querySelectorAll("div.cell.tag_exercise")) {
      const number = cell.dataset.exercise, chapter = number?.split(".")[0];
      cell.classList.toggle("exercise-accepted", Boolean(all[chapter]?.accepted.includes(number)));
    }
  }

  window.Live = { ...window.Live, exercises: {
    accepted(number) {
      const chapter = all[number.split(".")[0]];
      if (!chapter || chapter.accepted.includes(number)) return;
      chapter.accepted.push(number);
      chapters.write(all);
      tick();
    },
    forget() {
      for (const chapter of Object.values(all)) chapter.accepted = [];
      chapters.write(all);
      tick();
    },
  } };

  window.addEventListener("DOMContentLoaded", () => {
    const found = {};
    for (const cell of document.querySelectorAll("div.cell.tag_exercise")) {
      const [, number, chapter] = cell.textContent.match(CHECK) ?? [];
      if (!number) continue;
      cell.dataset.exercise = number;
      found[chapter] = (found[chapter] ?? new Set()).add(number);
    }
    for (const [chapter, numbers] of Object.entries(found))
      all[chapter] = { of: numbers.size, accepted: (all[chapter]?.accepted ?? []).filter((number) => numbers.has(number)) };
    tick();
  });
  window.addEventListener("storage", ({ key }) => { // another page of the book has changed them
    if (key !== KEY) return;
    all = { ...all, ...chapters.read() };
    tick();
  });
})();

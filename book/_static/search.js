/* The book's search, in place of Sphinx' own: whole words, without accents, whatever their ending; titles and headings
   before terms of the glossary, and these before text. Each page comes once, with the places in it that hold the words.
   What is searched: searchindex.js, which book/_ext/places.py writes. Sphinx' script asks, and calls Search.query. */
"use strict";
(() => {
  const WORD = /[\p{L}\p{N}_]+(?:[-‐‑][\p{L}\p{N}_]+)*/gu, PART = /[\p{L}\p{N}_]+/gu;
  const WIDTH = 240, PLACES = 3; // characters of a summary; places of a page that are named
  const QUESTION = "how do does i we you my can what when where which why who have has from about";
  const stemmer = new Stemmer(), stems = new Map(), ignored = new Set([...stopwords, ...QUESTION.split(" ")]);
  const sum = (list, value) => list.reduce((total, one) => total + value(one), 0);

  // -- words: each is counted as its stem, and as it is but for a plural's s

  const fold = (text) => text.normalize("NFD").replace(/\p{M}/gu, "").toLowerCase();
  const exact = (word) => `=${word.replace(/s$/, "")}`;
  function stem(word) {
    if (!stems.has(word)) stems.set(word, stemmer.stemWord(word));
    return stems.get(word);
  }

  // "pin-hole" is found as "pin", as "hole" and as "pinhole".
  function forms(word) {
    const parts = word.match(PART);
    return parts.length > 1 ? [...parts, parts.join("")] : parts;
  }
  const read = (text) => (fold(text).match(WORD) ?? []).flatMap(forms);

  function count(words) {
    const counts = new Map();
    for (const word of words) {
      for (const key of [stem(word), exact(word)]) counts.set(key, (counts.get(key) ?? 0) + 1);
    }
    return counts;
  }

  // A place of the index with its words counted; of a documented name, the last part is its heading.
  function counted([kind, anchor, title, text, about = []]) {
    const head = read(kind === "name" ? title.split(".").at(-1) : title), words = read(text);
    const telling = head.filter((word) => !ignored.has(word)).length, counts = count([...words, ...head]);
    return { kind, anchor, title, text, about, telling, size: words.length, head: count(head), counts };
  }

  // The pages of the index, their words counted: once, with the first query.
  function prepared(index) {
    return Object.entries(index).map(([url, rows]) => {
      const places = rows.map(counted), counts = new Map();
      for (const place of places) for (const [key, n] of place.counts) counts.set(key, (counts.get(key) ?? 0) + n);
      return { url, places, counts, head: places[0].head, weight: WEIGHTS.find(([part]) => url.includes(part))[1] };
    });
  }

  // Each word that is asked for: the stems that it stands for, and how much it tells (its rarity). One that is not in
  // the book stands for those that begin with it.
  function asked(query, pages) {
    const typed = [...new Set(fold(query).match(PART) ?? [])], telling = typed.filter((word) => !ignored.has(word));
    const places = pages.flatMap((page) => page.places);
    const known = new Set(pages.flatMap((page) => [...page.counts.keys()]));
    return (telling.length ? telling : typed).map((word) => {
      const longer = () => word.length < 3 ? [] : [...known].filter((other) => other.startsWith(word));
      const words = known.has(stem(word)) ? [stem(word)] : longer();
      const n = places.filter((place) => words.some((w) => place.counts.has(w))).length;
      return { words, exact: exact(word), rarity: Math.log(1 + (places.length - n + 0.5) / (n + 0.5)) };
    });
  }

  // -- ranking: what each part is worth was tried on the questions of book/tests/site/test_search.py

  const WEIGHTS = [["/chapters/", 1], ["/sources/", 0.7], ["/glossary", 0.7], ["/api/", 0.4], ["", 0.6]];
  const KINDS = { page: 8, section: 5, term: 4, exercise: 2, name: 2 };
  const ASIDE = /^(ex-|quiz|history-)/; // where a word is seldom explained
  const LENGTH = 120; // words of a section, about: as BM25, a long one must say a word more often

  const holds = (term, ...counts) => term.words.some((word) => counts.some((c) => c.has(word)));
  const mean = (terms, value) => sum(terms, (term) => term.rarity * value(term)) / sum(terms, (term) => term.rarity);
  const share = (terms, ...counts) => mean(terms, (term) => holds(term, ...counts) ? 1 : 0); // of what was asked
  const often = (terms, counts, half) => mean(terms, (term) => {
    const times = 0.6 * (counts.get(term.exact) ?? 0) + 0.4 * sum(term.words, (word) => counts.get(word) ?? 0);
    return times / (times + half);
  });

  // How well a heading is what was asked for, from 0 to 1: all words are in it, and few others.
  function named(terms, { head, telling }) {
    if (!terms.every((term) => holds(term, head))) return 0;
    const same = sum(terms, (term) => head.has(term.exact) ? 1 : 0.5) / terms.length;
    return same * (0.4 + 0.6 * terms.length / Math.max(telling, terms.length));
  }

  function placeScore(place, terms) {
    const heading = KINDS[place.kind] * named(terms, place) + 1.5 * often(terms, place.head, 0.5);
    const text = 2 * often(terms, place.counts, 0.4 + 0.8 * place.size / LENGTH);
    return (ASIDE.test(place.anchor) ? 0.5 : 1) * share(terms, place.counts) ** 2 * (heading + text);
  }

  // A term of the glossary says in which chapter it is explained.
  function explained(pages, terms) {
    const found = new Map();
    for (const place of pages.flatMap((page) => page.places)) {
      for (const url of place.about) found.set(url, Math.max(found.get(url) ?? 0, named(terms, place)));
    }
    return found;
  }

  // A page's places, best first. The first one holds all the words that the page has: it is the page if no other does.
  function best(page, terms) {
    const whole = share(terms, page.counts) - 1e-9;
    const places = page.places.map((place) => ({ ...place, score: placeScore(place, terms) }));
    const sorted = places.filter((place) => place.score > 0).sort((a, b) => b.score - a.score);
    const first = sorted.find((place) => share(terms, place.counts, page.head) > whole) ?? places[0];
    return [first, ...sorted.filter((place) => place !== first)];
  }

  // Pages with all the words, best first; if there is none, those with most of them.
  function ranked(query, pages) {
    const terms = asked(query, pages), about = explained(pages, terms);
    const most = Math.max(0, ...pages.map((page) => share(terms, page.counts)));
    const found = most > 0 ? pages.filter((page) => share(terms, page.counts) > most - 1e-9) : [];
    const results = found.map((page) => {
      const places = best(page, terms), top = Math.max(...places.map((place) => place.score));
      const subject = 2 * share(terms, page.head) + 3 * often(terms, page.counts, 12);
      const score = top + subject + 5 * (about.get(page.url) ?? 0);
      return { page, places, score: page.weight * score };
    });
    return { terms, all: most > 1 - 1e-9, results: results.sort((a, b) => b.score - a.score) };
  }

  // -- what is shown

  const make = (tag, textContent, more) => Object.assign(document.createElement(tag), { textContent, ...more });
  const root = document.documentElement.dataset.content_root;
  const address = ({ url }, { anchor }) => `${root}${url}${anchor && "#"}${anchor}`;
  const link = (page, place, text) => make("a", text, { href: address(page, place) });
  const name = ({ places: [{ title }] }, place) => place.kind === "page" ? title : `${title} › ${place.title}`;
  function isAsked(word, terms) {
    const found = forms(fold(word)).map(stem);
    return terms.some((term) => term.words.some((one) => found.includes(one)));
  }

  // The part of a text with most of the words, which are marked.
  function summary(text, terms) {
    const found = [...text.matchAll(WORD)].filter(([word]) => isAsked(word, terms));
    const after = ({ index }, first) => index >= first.index && index < first.index + WIDTH - 60;
    const within = (first) => found.filter((word) => after(word, first)).length;
    const densest = found.reduce((a, b) => within(b) > within(a) ? b : a, { index: 0 });
    let start = Math.max(0, densest.index - 60), end = Math.min(text.length, start + WIDTH);
    if (start) start = text.indexOf(" ", start) + 1;
    if (end < text.length) end = Math.max(text.lastIndexOf(" ", end), start);
    const shown = make("p", start ? "… " : "", { className: "context" });
    for (const { 0: word, index } of found.filter(({ index }) => index >= start && index < end)) {
      shown.append(text.slice(start, index), make("mark", word));
      start = index + word.length;
    }
    shown.append(text.slice(start, end), end < text.length ? " …" : "");
    return shown;
  }

  function item({ page, places }, terms) {
    const shown = make("li"), [first, ...others] = places;
    shown.append(link(page, first, name(page, first)));
    const told = places.find((place) => read(place.text).some((word) => isAsked(word, terms))) ?? first;
    if (told.text) shown.append(summary(told.text, terms));
    const also = others.filter((place) => place.score > first.score / 4).slice(0, PLACES - 1);
    if (also.length) shown.append(make("p", "Also: ", { className: "also" }));
    also.forEach((place, i) => shown.lastChild.append(i ? " · " : "", link(page, place, place.title)));
    return shown;
  }

  function told(n, all) {
    if (!n) return "No page has these words.";
    const pages = n === 1 ? "One page" : `${n} pages`;
    return all ? `${pages} found.` : `No page has all of these words. ${pages} with most of them:`;
  }

  let pages = null;
  Search.query = (query) => {
    pages ??= prepared(Search._index);
    const { terms, all, results } = ranked(query, pages);
    Search.stopPulse();
    Search.title.textContent = "Search results";
    Search.status.textContent = told(results.length, all);
    Search.output.append(...results.map((result) => item(result, terms)));
  };
})();

// What book/tools/pdf.py does to the page of all pages before it is printed: light colours, and smaller letters for
// formulas that are wider than the paper, which scroll on a screen.
() => {
  document.documentElement.dataset.theme = "light";
  for (const formula of document.querySelectorAll("mjx-container")) {
    const room = (formula.closest("p, li, dd, td, th, div") ?? document.querySelector("main")).clientWidth;
    const own = Math.max(formula.scrollWidth, formula.getBoundingClientRect().width);
    const size = parseFloat(getComputedStyle(formula).fontSize);
    if (own > room) formula.style.fontSize = `${(0.99 * size * room) / own}px`;
  }
  return document.fonts.ready;
}

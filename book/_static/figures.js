/* A slider is moved by its own oninput; browsers that restore a form's values on "back" need the frame set once more. */
window.addEventListener("pageshow", function () {
  document.querySelectorAll("figure.sweep :is(input[type=range], select)").forEach(function (range) {
    range.dispatchEvent(new Event("input"));
  });
});
/* A player in a cell tagged `plays` starts by itself, once, when it is seen whole; not for readers who want less motion,
   and not once they have touched it. */
window.addEventListener("load", function () {
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  document.querySelectorAll(".tag_plays figure.player").forEach(function (figure) {
    const seen = new IntersectionObserver(function ([stage]) {
      if (!stage.isIntersecting) return;
      seen.disconnect();
      figure.querySelector("[data-player=play]").click();
    }, { threshold: 0.9 });
    ["pointerdown", "keydown", "input"].forEach((type) => figure.addEventListener(type, () => seen.disconnect(), true));
    seen.observe(figure.querySelector(".player-stage"));
  });
});

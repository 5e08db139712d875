/* A slider is moved by its own oninput; browsers that restore a form's values on "back" need the frame set once more. */
window.addEventListener("pageshow", function () {
  document.querySelectorAll("figure.sweep input[type=range]").forEach(function (range) {
    range.dispatchEvent(new Event("input"));
  });
});

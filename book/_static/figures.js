/* A slider is moved by its own oninput; browsers that restore a form's values on "back" need the frame set once more. */
window.addEventListener("pageshow", function () {
  document.querySelectorAll("figure.sweep :is(input[type=range], select)").forEach(function (range) {
    range.dispatchEvent(new Event("input"));
  });
});

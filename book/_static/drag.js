/* Figures to hold in the hand (slambook.figures.dragging): handles that are dragged, by a pointer or with the arrow keys,
   and what follows from where they are, drawn at once.

   Each kind of figure is a file of its own, drag/NAME.js, fetched where a page shows one:

     Drag.add("NAME", {
       uses: ["ellipse"],                    // kinds whose formulas it calls, as Drag.kinds.ellipse.formulas; or nothing
       formulas: { square: (x) => x * x },   // compared with slamlib's in book/tests/test_dragging.py
       handles: {                            // in the order of the Tab key; they may not leave the axes
         peak: {
           label: "peak of the curve",
           at: (state) => [state.x, 1],               // where it is, in the numbers of its axes
           moved: (state, [x, y]) => ({ ...state, x }),   // the state once it is put there: limits are seen to here
           value: (state) => state.x,                 // what a slider is at, for those who cannot see it
           along: "x",                                // or "y": all arrow keys move it that way
         },
       },
       parts: (state) => ({                  // by the gid of what the cell has drawn; what it has not drawn is passed over
         curve: [[0, 0], [1, state.x]],      // the points of its line (closed if it was), or
         words: { at: [state.x, 1] },        // where it is moved, whole, as far as the axes go
       }),
       numbers: (state) => ({ x: state.x }), // for the places of the line below, {x:.2f}
     });

   A handle that has a part's name is in the axes of that part, else in the first that have parts. */
const Drag = (() => {
  const kinds = {}, asked = {}, home = document.currentScript.src;
  const SVG = "http://www.w3.org/2000/svg", REACH = 22, SEEN = 7; // radii in pixels: what takes a finger, and what is seen
  const ARROWS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowDown: [0, -1], ArrowUp: [0, 1] };
  const HINT = "Drag the round handles", KEYS = ", or move them with the arrow keys (with Shift in larger steps)";
  const within = (value, a, b) => Math.min(Math.max(value, Math.min(a, b)), Math.max(a, b));
  const make = (name, attributes) => {
    const made = document.createElementNS(SVG, name);
    for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
    return made;
  };

  /** "ρ = {rho:.2f}" with its numbers. */
  function filled(template, numbers) {
    return template.replace(/\{(\w+):\.(\d)f\}/g, (_, name, digits) => {
      const text = numbers[name].toFixed(digits);
      return Number(text) ? text.replace("-", "\u2212") : text.replace("-", "");
    });
  }

  /** Axes of the figure: data to points on the sheet, and back. */
  function viewOf(group) {
    const [left, top, right, bottom, x0, x1, y0, y1] = group.dataset.view.split(" ").map(Number);
    return {
      place: ([x, y]) => [left + ((x - x0) / (x1 - x0)) * (right - left), bottom + ((y - y0) / (y1 - y0)) * (top - bottom)],
      number: ([x, y]) => [x0 + ((x - left) / (right - left)) * (x1 - x0), y0 + ((y - bottom) / (top - bottom)) * (y1 - y0)],
      inside: ([x, y]) => [within(x, x0, x1), within(y, y0, y1)],
      step: [(x1 - x0) / 100, (y1 - y0) / 100],
    };
  }

  function load(name) {
    return asked[name] ??= new Promise((done, failed) => {
      const script = Object.assign(document.createElement("script"), { src: new URL(`drag/${name}.js`, home), onload: done });
      script.onerror = () => failed(new Error(`drag/${name}.js cannot be had`));
      document.head.append(script);
    }).then(() => Promise.all((kinds[name].uses ?? []).map(load))).then(() => kinds[name]);
  }

  async function hold(figure) {
    figure.dataset.held = "";
    const kind = await load(figure.dataset.drag);
    const svg = figure.querySelector("svg"), note = figure.querySelector(".sweep-note"), groups = {};
    const start = JSON.parse(figure.dataset.start), first = kind.parts(start);
    let state = start;
    svg.querySelectorAll("[data-part]").forEach((group) => { groups[group.dataset.part] = group; });
    const views = new Map([...svg.querySelectorAll("[data-view]")].map((group) => [group, viewOf(group)]));
    const viewFor = (name) => groups[name] ? views.get(groups[name].closest("[data-view]")) : views.values().next().value;

    function drawn(name, what) {
      const group = groups[name], { place, inside } = viewFor(name);
      if (Array.isArray(what)) {
        const path = group.querySelector("path"), closed = /z$/i.test(path.getAttribute("d"));
        const points = what.map((point) => place(point).map((v) => within(v, -1e4, 1e4).toFixed(2)).join(" "));
        path.setAttribute("d", `M${points.join("L")}${closed ? "z" : ""}`);
      } else {
        const [from, to] = [first[name].at, what.at].map((point) => place(inside(point)));
        group.setAttribute("transform", `translate(${(to[0] - from[0]).toFixed(2)} ${(to[1] - from[1]).toFixed(2)})`);
      }
    }
    function redraw() {
      for (const [name, what] of Object.entries(kind.parts(state))) if (groups[name]) drawn(name, what);
      note.textContent = filled(figure.dataset.says, kind.numbers(state));
      for (const { handle, of, view } of handles) {
        const at = of.at(state), [x, y] = view.place(view.inside(at)), value = of.value?.(state) ?? at[0];
        handle.setAttribute("transform", `translate(${x.toFixed(2)} ${y.toFixed(2)})`);
        handle.setAttribute("aria-valuenow", +value.toPrecision(6));
        const where = of.value ? value.toPrecision(3) : at.map((v) => v.toPrecision(3)).join(", ");
        handle.setAttribute("aria-valuetext", `${where}. ${note.textContent}`);
      }
    }
    function put(of, view, point) {
      state = of.moved(state, view.inside(point));
      redraw();
    }

    const used = Object.entries(kind.handles).filter(([, of]) => of.at(start)); // a state may do without the point of one
    const handles = used.map(([name, of]) => {
      const view = viewFor(name);
      const handle = make("g", { class: "drag-handle", tabindex: 0, role: "slider", "aria-label": of.label });
      handle.dataset.handle = name;
      handle.append(make("circle", { class: "reach" }), make("circle", { class: "seen" }));
      let off = null; // from the pointer to the handle's middle, while it is held
      const at = (event) => {
        const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
        return [x, y];
      };
      handle.addEventListener("pointerdown", (event) => {
        if (event.button) return;
        const middle = view.place(view.inside(of.at(state))), pointer = at(event);
        off = [middle[0] - pointer[0], middle[1] - pointer[1]];
        handle.setPointerCapture(event.pointerId);
        handle.focus({ preventScroll: true });
        event.preventDefault();
      });
      handle.addEventListener("pointermove", (event) => {
        if (!off) return;
        const pointer = at(event);
        put(of, view, view.number([pointer[0] + off[0], pointer[1] + off[1]]));
      });
      ["pointerup", "pointercancel", "lostpointercapture"].forEach((type) => handle.addEventListener(type, () => { off = null; }));
      handle.addEventListener("keydown", (event) => {
        const way = ARROWS[event.key];
        if (!way || event.ctrlKey || event.altKey || event.metaKey) return;
        const from = of.at(state), size = event.shiftKey ? 10 : 1, both = way[0] + way[1];
        const [dx, dy] = of.along ? [of.along === "x" ? both : 0, of.along === "y" ? both : 0] : way;
        put(of, view, [from[0] + size * dx * view.step[0], from[1] + size * dy * view.step[1]]);
        event.preventDefault();
      });
      svg.append(handle);
      return { handle, of, view };
    });
    const reset = Object.assign(document.createElement("button"), { type: "button", textContent: "Start over" });
    reset.addEventListener("click", () => {
      state = start;
      redraw();
    });
    const bar = Object.assign(document.createElement("div"), { className: "drag-bar" });
    const hint = Object.assign(document.createElement("span"), { textContent: HINT });
    hint.append(Object.assign(document.createElement("span"), { className: "keys", textContent: KEYS }), ".");
    bar.append(hint, reset);
    figure.append(bar);
    svg.setAttribute("role", "group"); // of an image a screen reader tells no parts
    new ResizeObserver(() => {
      const scale = svg.getScreenCTM()?.a;
      if (!scale) return; // in a closed fold
      for (const [name, radius] of [["reach", REACH], ["seen", SEEN]]) {
        svg.querySelectorAll(`.drag-handle .${name}`).forEach((circle) => circle.setAttribute("r", (radius / scale).toFixed(2)));
      }
    }).observe(svg);
    redraw();
    figure.dataset.held = "yes";
  }

  // Also of figures that a cell shows when its reader runs it. One whose file does not come stays the picture that it is.
  const all = () => document.querySelectorAll("figure.drag:not([data-held])").forEach((f) => { hold(f).catch(console.error); });
  document.addEventListener("DOMContentLoaded", () => {
    all();
    new MutationObserver(all).observe(document.body, { childList: true, subtree: true });
  });
  return { kinds, add: (name, kind) => { kinds[name] = kind; }, load, filled };
})();

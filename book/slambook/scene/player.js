/* An interactive map that lives in a page: plays, steps and turns frames that were computed before. Python: player.py.

The figure is a still picture until somebody touches it. Space: right-handed, z up. The sheet: points of the SVG. */
"use strict";
window.slamlibPlayer = function (figure) {
  const data = JSON.parse(figure.querySelector(".player-data").textContent);
  const find = (name) => figure.querySelector(`[data-player="${name}"]`);
  const [svg, second] = figure.querySelectorAll(".player-stage svg"), slider = find("frame"), still = data.frames.length - 1;
  const [, , width, height] = svg.getAttribute("viewBox").split(" ").map(Number);
  const scale = height / 2 - data.pad, near = 0.05;
  const state = { frame: Number(slider.value), playing: false, orbiting: false, azimuth: 0, elevation: 0, zoom: 1, view: null };

  /* Of each frame all landmarks: a frame's data has those alone that differ from the frame before. */
  const landmarks = [];
  for (const frame of data.frames) {
    const all = new Map(landmarks[landmarks.length - 1]);
    frame.gone.forEach((id) => all.delete(id));
    Object.entries(frame.landmarks).forEach(([id, row]) => all.set(id, row));
    landmarks.push(all);
  }
  const track = (key) => data.frames[0][key].map((_, robot) => data.frames.map((frame) => frame[key][robot]));
  const tracks = { robot: track("at"), truth: track("true") };

  /* The virtual camera: the same formulas as view.py. */
  const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  class Camera {
    constructor() {
      const { view, frame } = state, robot = data.frames[frame];
      const a = (view.azimuth + state.azimuth + (view.follows ? robot.heading : 0)) * Math.PI / 180;
      const e = Math.max(-90, Math.min(90, view.elevation + state.elevation)) * Math.PI / 180;
      const [ca, sa, ce, se] = [Math.cos(a), Math.sin(a), Math.cos(e), Math.sin(e)];
      this.rows = [[-sa, ca, 0], [-se * ca, -se * sa, ce], [ce * ca, ce * sa, se]];
      this.target = view.follows ? robot.at[0] : view.target;
      this.distance = view.distance / state.zoom;
      this.focal = 1 / Math.tan(view.field * Math.PI / 360);
    }
    seen(p) {
      const q = p.map((v, i) => v - this.target[i]);
      return [dot(this.rows[0], q), dot(this.rows[1], q), this.distance - dot(this.rows[2], q)];
    }
    ahead(s) { return !data.perspective || s[2] >= near * this.distance; }
    sheet(s) {
      const factor = scale * this.focal / (data.perspective ? s[2] : this.distance);
      return [width / 2 + factor * s[0], height / 2 - factor * s[1]];
    }
    point(p) { const s = this.seen(p); return this.ahead(s) ? this.sheet(s) : null; }
    line(points) { return this.path(points.map((p) => this.seen(p))); }
    path(seen) {
      let text = "", before = null;
      for (const s of seen) {
        if (before && this.ahead(before) !== this.ahead(s)) {
          const share = (near * this.distance - before[2]) / (s[2] - before[2]);
          const cut = written(this.sheet(before.map((v, i) => v + share * (s[i] - v))));
          text += this.ahead(s) ? `M${cut}` : `L${cut}`;
        }
        if (this.ahead(s)) text += (before ? "L" : "M") + written(this.sheet(s));
        before = s;
      }
      return text;
    }
    /* The outline of the ellipsoid around a point with this lower triangular factor (6); see View._rings. */
    outline(p, [a, b, c, d, e, f]) {
      const m = this.rows.map(([x, y, z]) => [x * a + y * b + z * d, y * c + z * e, z * f]);
      m[2] = m[2].map((v) => -v);
      const s = m.map((r) => m.map((t) => dot(r, t))), [x, y, z] = this.seen(p);
      if (data.perspective && z - Math.sqrt(s[2][2]) <= near * this.distance) return this.longest([x, y, z], s);
      const w = data.perspective ? z * z - s[2][2] : 1, k = data.perspective ? z : 1;
      const u = (x * k - (data.perspective ? s[0][2] : 0)) / w, v = (y * k - (data.perspective ? s[1][2] : 0)) / w;
      const flat = (i, j, pi, pj, ui, uj) => data.perspective ? (s[i][j] - pi * pj) / w + ui * uj : s[i][j];
      const [xx, xy, yy] = [flat(0, 0, x, x, u, u), flat(0, 1, x, y, u, v), flat(1, 1, y, y, v, v)];
      const factor = scale * this.focal / (data.perspective ? 1 : this.distance);
      const half = (xx + yy) / 2, root = Math.hypot((xx - yy) / 2, xy), turn = Math.atan2(2 * xy, xx - yy) / 2;
      const [large, small] = [half + root, Math.max(half - root, 0)].map((t) => factor * Math.sqrt(t));
      return outline(width / 2 + factor * u, height / 2 - factor * v, large, small, -turn);
    }
    longest(c, s) {
      let v = [s[0][0], s[1][1], s[2][2]].map((t, i, all) => s[i][all.indexOf(Math.max(...all))]);
      for (let i = 0; i < 20; i++) {
        const length = Math.hypot(...v) || 1;
        v = s.map((row) => dot(row, v) / length);
      }
      const length = Math.hypot(...v) || 1, half = Math.sqrt(length);
      return this.path([-1, 1].map((sign) => c.map((t, i) => t + sign * half * v[i] / length)));
    }
  }
  /* An ellipse by its middle, half axes, and the turn of the larger one, downwards. */
  function outline(x, y, large, small, turn) {
    if (large < 0.3) return "";
    const [dx, dy] = [large * Math.cos(turn), large * Math.sin(turn)];
    const arc = `A${short(large)} ${short(Math.max(small, 0.01))} ${short(turn * 180 / Math.PI)} 0 0 `;
    return `M${written([x - dx, y - dy])}${arc}${written([x + dx, y + dy])}${arc}${written([x - dx, y - dy])}`;
  }
  const short = (v) => String(Math.round(v * 10) / 10);
  const written = (p) => p.map(short).join(" ");
  const shapes = {
    o: ([x, y], r) => `M${short(x - r)} ${short(y)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0z`,
    x: ([x, y], r) => `M${short(x - r)} ${short(y - r)}l${2 * r} ${2 * r}m0 ${-2 * r}l${-2 * r} ${2 * r}`,
    "+": ([x, y], r) => `M${short(x - r)} ${short(y)}h${2 * r}M${short(x)} ${short(y - r)}v${2 * r}`,
  };

  /* What is drawn: made once, and changed from frame to frame. */
  const element = (tag, style, parent) => {
    const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
    if (style) made.setAttribute("style", style);
    return parent.appendChild(made);
  };
  const emptied = (sheet, roles) => {
    sheet.replaceChildren();
    return Object.entries(roles).map(([name, role]) => {
      const group = element("g", "", sheet), shape = (style) => element("path", style, group);
      const halo = role.halo && shape(role.halo);
      return { name, role, group, halo, lines: shape(role.line), shells: shape(role.shell), marks: shape(role.mark), words: [] };
    });
  };
  const layers = emptied(svg, data.roles), seen = second ? emptied(second, data.sensor.over || data.sensor.roles) : [];
  const photo = second && data.sensor.over ? second.insertBefore(element("image", "", second), second.firstChild) : null;

  function contents(name) {
    const frame = data.frames[state.frame], found = { lines: [], balls: [], marks: [], words: [] };
    found.lines.push(...(data.still[name]?.lines || []), ...(frame.lines[name] || []));
    found.marks.push(...(data.still[name]?.marks || []));
    (tracks[name] || []).forEach((points) => found.lines.push(points.slice(0, state.frame + 1)));
    if (name === "robot") found.balls.push(...frame.balls);
    for (const [id, [kind, ...numbers]] of landmarks[state.frame]) {
      if (name !== data.kinds[kind] && name !== "label") continue;
      const ends = [];
      for (let i = 0; i < numbers.length; i += 9) ends.push(numbers.slice(i, i + 3));
      if (name === "label") {
        const middle = ends[0].map((v, i) => (v + ends[ends.length - 1][i]) / 2);
        found.words.push([middle.map((x, axis) => x + data.above[axis]), id.slice(1)]);
        continue;
      }
      if (ends.length > 1) found.lines.push(ends); else found.marks.push(ends[0]);
      ends.forEach((end, i) => found.balls.push([...end, ...numbers.slice(9 * i + 3, 9 * i + 9)]));
    }
    return found;
  }

  /* What a sensor saw: of each prediction its landmark's number, its outcome, and the predicted and the measured position. */
  const scales = () => {
    const [left, right, low, high] = data.sensor.limits, [, , wide, tall] = second.getAttribute("viewBox").split(" ").map(Number);
    const [across, down] = [(wide - 2 * data.pad) / (right - left), (tall - 2 * data.pad) / (low - high)];
    return { across, down, left, right, low, high, place: (u, v) => [data.pad + across * (u - left), data.pad + down * (v - high)] };
  };
  function develop() {
    const { image, extent } = data.frames[state.frame].measurements, { place } = scales();
    photo.setAttribute("href", image || "data:,");
    if (!image) return;
    const [x, y] = place(extent[0], extent[3]), [right, bottom] = place(extent[1], extent[2]);
    Object.entries({ x, y, width: right - x, height: bottom - y, preserveAspectRatio: "none" }).forEach((pair) => photo.setAttribute(...pair));
  }
  function sight(name) {
    const { across, down, left, right, low, high, place } = scales();
    const line = (a, b) => `M${written(place(...a))}L${written(place(...b))}`;
    const { raw, points, segments, scores } = data.frames[state.frame].measurements, found = { lines: "", shells: "", marks: [], words: [] };
    if (name === "raw") {
      if (!photo) found.lines = line([left, high], [right, high]) + line([right, high], [right, low]) + line([right, low], [left, low]) + line([left, low], [left, high]);
      raw.segments.forEach(([a, b, c, d]) => { found.lines += line([a, b], [c, d]); });
      found.marks = raw.points.map((p) => place(...p));
    }
    for (const [id, role, known, u, v, a, b, c, ...measured] of points) {
      const at = place(u, v);
      if (name === data.sensor.outcomes[role]) found.shells += ellipse(at, [across * a, down * b, down * c]);
      if (name === (known ? "point" : "new point")) found.marks.push(at);
      if (name === "label") found.words.push([at, String(id)]);
      if (name === "measured" && measured.length) {
        found.lines += line([u, v], measured);
        found.marks.push(place(...measured));
      }
    }
    for (const [id, role, known, x, y, a, b, c, d, ends, ...measured] of segments) {
      for (const [u, v, e, f, g] of ends) {
        if (name === data.sensor.outcomes[role]) found.shells += ellipse(place(u, v), [across * e, down * f, down * g]);
        if (name === (known ? "point" : "new point")) found.marks.push(place(u, v));
      }
      if (name === data.sensor.outcomes[role]) found.lines += line([a, b], [c, d]);
      if (name === "line label") found.words.push([place(x, y), String(id)]);
      if (name === "measured" && measured.length) found.marks.push(place(measured[0], measured[1]), place(measured[2], measured[3]));
    }
    if (name === "score") scores.forEach(([u, v, word]) => found.words.push([place(u, v), word]));
    return found;
  }
  /* An ellipse around a place of the sheet with this lower triangular factor. */
  function ellipse([x, y], [a, b, c]) {
    const [xx, xy, yy] = [a * a, a * b, b * b + c * c], half = (xx + yy) / 2, root = Math.hypot((xx - yy) / 2, xy);
    return outline(x, y, Math.sqrt(half + root), Math.sqrt(Math.max(half - root, 0)), Math.atan2(2 * xy, xx - yy) / 2);
  }

  function onto(layer, camera) {
    const { lines, balls, marks, words } = contents(layer.name);
    return {
      lines: lines.map((line) => camera.line(line)).join(""),
      shells: balls.map((b) => camera.outline(b.slice(0, 3), b.slice(3))).join(""),
      marks: marks.map((p) => camera.point(p)).filter(Boolean),
      words: words.map(([p, word]) => [camera.point(p), word]).filter(([p]) => p),
    };
  }
  function show({ role, group, halo, lines, shells, marks, words }, found) {
    const mark = shapes[role.marker] || shapes.o, shown = find("labels").checked ? found.words : [];
    lines.setAttribute("d", found.lines);
    shells.setAttribute("d", found.shells);
    marks.setAttribute("d", found.marks.map((p) => mark(p, role.size / 2)).join(""));
    if (halo) halo.setAttribute("d", [lines, shells, marks].map((path) => path.getAttribute("d")).join(""));
    while (words.length < shown.length) words.push(element("text", role.text, group));
    words.forEach((text, i) => {
      const [p, word] = shown[i] || [[-99, -99], ""];
      text.setAttribute("x", short(p[0]));
      text.setAttribute("y", short(p[1] - role.raised));
      if (text.textContent !== word) text.textContent = word;
    });
  }

  function draw() {
    const camera = new Camera();
    layers.forEach((layer) => show(layer, onto(layer, camera)));
    seen.forEach((layer) => show(layer, sight(layer.name)));
    if (photo) develop();
    const { said, note } = data.frames[state.frame];
    slider.value = state.frame;
    slider.setAttribute("aria-valuetext", said);
    find("said").textContent = said;
    if (!state.playing) find("note").textContent = note;
    find("play").textContent = state.playing ? "Pause" : "Play";
    find("orbit").setAttribute("aria-pressed", String(state.orbiting));
  }

  /* Time: one clock for playing and for the orbit; it stands still when there is nothing to do. */
  let clock = null, last = 0, owed = 0;
  function tick(now) {
    const passed = Math.max(0, Math.min(now - last, 200)) / 1000;
    last = now;
    owed += state.playing ? passed * data.fps : 0;
    const steps = Math.floor(owed);
    owed -= steps;
    state.frame = Math.min(state.frame + steps, still);
    if (state.frame === still) state.playing = false;
    if (state.orbiting) state.azimuth += 20 * passed;
    if (steps || state.orbiting) draw();
    clock = (state.playing || state.orbiting) && figure.isConnected ? requestAnimationFrame(tick) : null;
  }
  function wake() {
    if (clock === null) { last = performance.now(); owed = 0; clock = requestAnimationFrame(tick); }
  }

  const look = (name) => Object.assign(state, { view: data.views[name], azimuth: 0, elevation: 0, zoom: 1 });
  const step = (by) => Object.assign(state, { playing: false, frame: Math.max(0, Math.min(still, state.frame + by)) });
  const zoom = (by) => { state.zoom = Math.max(0.2, Math.min(20, state.zoom * by)); };
  const turn = (azimuth, elevation) => {
    const { view } = state;
    state.azimuth += azimuth;
    state.elevation = Math.max(-90, Math.min(90, view.elevation + state.elevation + elevation)) - view.elevation;
  };
  const clicks = {
    play() {
      state.playing = !state.playing;
      if (state.playing && state.frame === still) state.frame = 0;
      wake();
    },
    back: () => step(-1), on: () => step(1),
    nearer: () => zoom(1.25), farther: () => zoom(0.8),
    orbit() { state.orbiting = !state.orbiting; wake(); },
  };
  const inputs = {
    frame: () => Object.assign(state, { playing: false, frame: Number(slider.value) }),
    view: () => look(find("view").value),
    labels() {},
  };
  const keys = {
    ArrowLeft: () => turn(-5, 0), ArrowRight: () => turn(5, 0), ArrowUp: () => turn(0, 5), ArrowDown: () => turn(0, -5),
    "+": clicks.nearer, "=": clicks.nearer, "-": clicks.farther, " ": clicks.play, ".": clicks.on, ",": clicks.back,
  };
  let held = null;
  const acts = {
    click: (event) => clicks[event.target.dataset.player],
    input: (event) => inputs[event.target.dataset.player],
    keydown: (event) => event.target === find("stage") && !event.ctrlKey && !event.metaKey && !event.altKey && keys[event.key],
    pointerdown(event) {
      if (find("stage").contains(event.target)) held = [event.clientX, event.clientY];
    },
    pointermove(event) {
      if (!held || !event.buttons) return null;
      const [dx, dy] = [event.clientX - held[0], event.clientY - held[1]];
      held = [event.clientX, event.clientY];
      return () => turn(-0.4 * dx, 0.4 * dy);
    },
    pointerup() { held = null; },
    pointercancel() { held = null; },
  };
  const act = (event) => {
    const deed = acts[event.type]?.(event);
    if (!deed) return;
    if (event.type === "keydown") event.preventDefault();
    deed();
    draw();
  };
  ["onclick", "oninput", "onkeydown", "onpointerdown"].forEach((name) => figure.removeAttribute(name));
  Object.keys(acts).forEach((type) => figure.addEventListener(type, act));
  look(find("view").value);
  draw();
  return act;
};

/* Python for one page. It fetches the files of manifest.json, says how far it is, and runs what the page sends.
   Messages in:  {run, cell, code, limit}, {frame, key, position}  (run and frame are numbers that come back in the answers)
   Messages out: {progress}, {ready}, {fetching}, {shown}, {done}, {frame}, {fatal} */
"use strict";

const base = new URL("./", self.location.href).href;
const post = (message) => self.postMessage(message);
let runner, fetchPictures, running = 0;

class Unreachable extends Error {}

async function fetched(name, size, progress) {
  let seen = 0;
  try {
    const answer = await fetch(base + name);
    if (!answer.ok) throw new Unreachable(`${name}: the server answers ${answer.status}`);
    const reader = answer.body.getReader(), parts = [];
    for (;;) {
      const { done, value } = await reader.read();
      if (done) break;
      parts.push(value);
      seen += value.length;
      progress(name, seen);
    }
    if (size !== undefined && seen !== size) throw new TypeError("incomplete");
    return new Uint8Array(await new Blob(parts).arrayBuffer());
  } catch (error) {
    if (error instanceof Unreachable) throw error;
    const megabytes = (n) => (n / 1e6).toFixed(1);
    throw new Unreachable(
      `the connection was lost while fetching ${name} (${megabytes(seen)} of ${megabytes(size || seen)} MB)`);
  }
}

/* Python waits for a package that it imports: the one place where a worker may, and must, fetch without returning. */
function fetchedNow(name, size) {
  post({ fetching: { name, bytes: size } });
  const request = new XMLHttpRequest();
  request.open("GET", base + name, false);
  request.responseType = "arraybuffer";
  try {
    request.send();
  } catch (error) {
    throw new Unreachable(`${name} cannot be fetched: is the connection lost?`);
  }
  if (request.status !== 200 || request.response.byteLength !== size) throw new Unreachable(`${name} cannot be fetched`);
  post({ fetching: null });
  return new Uint8Array(request.response);
}

/* Pictures come when a cell names their folder. This Python cannot read JPEG, but the browser can: so each file is
   replaced by its grey values (PGM), and what reads those is imported as OpenCV. */
function picturesFor(python, manifest, packages) {
  const wanted = new Set(Object.keys(manifest.files).filter((name) => name.startsWith("pictures/")));
  const get = (name) => fetched(name, manifest.files[name].bytes, () => {});
  return async (code) => {
    for (const archive of wanted) {
      const folder = archive.replace(".zip", "");
      if (!code.includes(folder)) continue;
      post({ fetching: { name: archive, bytes: manifest.files[archive].bytes } });
      const [packed, reader] = await Promise.all([archive, "opencv.py"].map(get));
      python.unpackArchive(packed, "zip", { extractDir: "." });
      const found = python.runPython(`import pathlib; [str(f) for f in pathlib.Path("${folder}").rglob("*.jpg")]`);
      for (const name of found.toJs()) python.FS.writeFile(name, await grey(python.FS.readFile(name)));
      python.FS.writeFile(packages + "/cv2.py", reader);
      python.runPython("import importlib; importlib.invalidate_caches()");
      wanted.delete(archive);
      post({ fetching: null });
    }
  };
}

/* A grey picture's file as PGM: red, green, and blue are the same. */
async function grey(file) {
  const bitmap = await createImageBitmap(new Blob([file]), { colorSpaceConversion: "none" });
  const { width, height } = bitmap, canvas = new OffscreenCanvas(width, height).getContext("2d");
  canvas.drawImage(bitmap, 0, 0);
  const pixels = canvas.getImageData(0, 0, width, height).data.filter((_, i) => i % 4 === 0);
  return new Uint8Array(await new Blob([`P5 ${width} ${height} 255\n`, pixels]).arrayBuffer());
}

async function unzipped(bytes) {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer());
}

async function start() {
  const began = performance.now();
  if (typeof WebAssembly !== "object") throw new Unreachable("this browser has no WebAssembly");
  const manifest = JSON.parse(new TextDecoder().decode(await fetched("manifest.json", undefined, () => {})));
  const size = (name) => manifest.files[name].bytes;
  const names = [...manifest.first, ...manifest.data], loaded = {};
  const total = names.reduce((sum, name) => sum + size(name), 0);
  const progress = (name, bytes) => {
    loaded[name] = bytes;
    post({ progress: { name, bytes: Object.values(loaded).reduce((a, b) => a + b, 0), total } });
  };
  const contents = await Promise.all(names.map((name) => fetched(name, size(name), progress)));
  const file = Object.fromEntries(names.map((name, i) => [name, contents[i]]));
  const [script, machine] = await Promise.all([unzipped(file["pyodide.asm.js.bin"]), unzipped(file["pyodide.asm.wasm.bin"])]);
  post({ starting: true });

  importScripts(base + "pyodide.js", URL.createObjectURL(new Blob([script], { type: "text/javascript" })));
  const held = {
    "pyodide.asm.wasm": [machine, "application/wasm"],
    "python_stdlib.zip": [file["python_stdlib.zip"], "application/zip"],
    "pyodide-lock.json": [JSON.stringify(manifest.lock), "application/json"],
  };
  const outside = self.fetch;
  self.fetch = (request, options) => {
    const [content, type] = held[String(request.url || request).split("/").pop()] || [];
    return content ? Promise.resolve(new Response(content, { headers: { "Content-Type": type } })) : outside(request, options);
  };
  const python = await loadPyodide({ indexURL: base });
  self.fetch = outside;

  const packages = python.runPython("import site; site.getsitepackages()[0]");
  for (const name of ["numpy.zip", manifest.wheel, "standin.zip"]) python.unpackArchive(file[name], "zip", { extractDir: packages });
  python.FS.mkdirTree("/book/chapters/data");
  for (const name of manifest.data) python.FS.writeFile("/book/chapters/" + name, file[name]);
  python.FS.chdir("/book/chapters");
  python.FS.writeFile(packages + "/book_runner.py", file["runner.py"]);
  const send = (kind, text) => post({ shown: running, kind, text });
  const later = python.toPy(manifest.later);
  const fetchNow = (name) => python.toPy(fetchedNow(name, size(name)));
  runner = python.pyimport("book_runner").Runner(send, fetchNow, later);
  python.runPython("import numpy, slamlib");
  fetchPictures = picturesFor(python, manifest, packages);
  post({ ready: { seconds: (performance.now() - began) / 1000, bytes: total } });
}

const started = start().catch((error) => {
  post({ fatal: String(error.message || error) });
  throw error;
});

async function answer(data) {
  try {
    if (data.run !== undefined) {
      running = data.run;
      await fetchPictures(data.code).catch((error) => {
        post({ shown: running, kind: "stderr", text: `The pictures are not here: ${error.message}\n` });
      });
      const began = performance.now();
      const ok = runner.run(data.code, data.cell, data.limit);
      post({ done: data.run, ok, milliseconds: performance.now() - began });
    } else {
      post({ frame: data.frame, drawn: JSON.parse(runner.frame(data.key, data.position)) });
    }
  } catch (error) {
    if (data.frame !== undefined && error.type) post({ frame: data.frame, failed: String(error.message) });
    else post({ fatal: "Python stopped: " + String(error.message || error).split("\n").slice(-3).join(" ") });
  }
}

/* One message after the other; none if Python did not start, which the page has been told. */
let last = started;
self.onmessage = ({ data }) => {
  last = last.then(() => answer(data));
  last.catch(() => {});
};

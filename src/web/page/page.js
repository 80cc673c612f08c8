/* page.js - the page: the model, the view, the controls, what is shown and what is saved. */
import { classes } from "./live.js";
import {
  lineArguments,
  oblique,
  outputName,
  pens,
  presets,
  programArguments,
  quoted,
  sceneArguments,
} from "./command.js";

const by = (id) => document.getElementById(id);
const controls = by("controls"),
  stage = by("stage"),
  paper = by("paper"),
  still = by("still"),
  canvas = by("canvas");
const SLOW = 120; // ms of a frame above which hidden lines are left out while the model is turned
const REST = 250; // ms without a change before the page is drawn

/* ---- workers ---- */

/* A worker whose calls are answered by promises. When it is ended, its promises never come. */
class Helper {
  constructor() {
    this.worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    this.waiting = new Map();
    this.next = 0;
    this.worker.onmessage = ({ data }) => {
      this.waiting.get(data.id)?.(data);
      this.waiting.delete(data.id);
    };
    this.worker.onerror = (event) =>
      say(`The page cannot work here: ${event.message ?? "its worker did not start"}`, true);
  }

  ask(kind, rest) {
    const id = this.next++;
    this.worker.postMessage({ id, kind, ...rest });
    return new Promise((resolve) => this.waiting.set(id, resolve));
  }

  end() {
    this.worker.terminate();
  }
}

const compiled = (async () => WebAssembly.compile(await (await fetch("./roberts.wasm")).arrayBuffer()))();

/* ---- the state ---- */

const view = { view: "iso", azimuth: presets.iso[0], elevation: presets.iso[1] };
let scene; // of the last frame: centre, diameter, counts
let model; // { name, file, materials, live, printer, ready }

function state() {
  const form = new FormData(controls);
  const text = (name) => String(form.get(name) ?? "").trim();
  const is = (name) => form.has(name);
  return {
    name: model?.name ?? "model.off",
    ...view,
    perspective: text("perspective"),
    up: text("up"),
    hidden: text("hidden"),
    crease: text("crease"),
    allEdges: is("allEdges"),
    union: is("union"),
    hull: is("hull"),
    rounded: is("rounded"),
    fill: text("fill"),
    hatch: is("hatch"),
    page: text("page"),
    landscape: is("landscape"),
    scale: text("scale"),
    unit: text("unit"),
    margin: text("margin"),
    frame: is("frame"),
    pens: Object.fromEntries(
      Object.keys(pens).map((name) => [
        name,
        {
          on: is(`${name}-on`),
          width: text(`${name}-width`) || pens[name],
          color: text(`${name}-color`),
        },
      ]),
    ),
  };
}

/* ---- what is said ---- */

function say(text, wrong = false) {
  const box = by("messages");
  box.hidden = text === "";
  box.classList.toggle("wrong", wrong);
  if (box.textContent !== text) box.textContent = text;
}

function count(number, one, many = `${one}s`) {
  return `${number.toLocaleString("en")} ${number === 1 ? one : many}`;
}

function tellScene() {
  by("about").textContent = scene
    ? `${model.name}: ${count(scene.bodies, "body", "bodies")}, ${count(scene.faces, "face")}`
    : "";
}

/* No command that is known to fail. */
function showCommand(works = model?.ready) {
  by("command").textContent = works
    ? ["roberts", ...programArguments(state(), scene, "svg")].map(quoted).join(" ")
    : "";
}

/* ---- the page on the screen ---- */

const sizes = {
  a5: [148, 210],
  a4: [210, 297],
  a3: [297, 420],
  a2: [420, 594],
  letter: [215.9, 279.4],
  legal: [215.9, 355.6],
  tabloid: [279.4, 431.8],
};

function sheet() {
  const { page, landscape } = state(),
    [short, long] = sizes[page];
  return landscape ? [long, short] : [short, long];
}

/* Lays the paper in the middle of the stage, as large as it fits. Returns its place in pixels, and pixels per mm. */
function layPaper() {
  const [width, height] = sheet(),
    room = 14;
  const per = Math.min((stage.clientWidth - 2 * room) / width, (stage.clientHeight - 2 * room) / height);
  const box = { width: width * per, height: height * per, per };
  box.x = (stage.clientWidth - box.width) / 2;
  box.y = (stage.clientHeight - box.height) / 2;
  Object.assign(paper.style, {
    left: `${box.x}px`,
    top: `${box.y}px`,
    width: `${box.width}px`,
    height: `${box.height}px`,
  });
  return box;
}

let zoom; // pixels per unit of the model, kept while the model is turned
const units = { mm: 1, cm: 10, m: 1000, in: 25.4, ft: 304.8 };

/* Pixels per unit of the model: by the scale, as 1:20 or 0.05; without one, as large as fits. */
function scaled(window, box) {
  const { scale, unit } = state(),
    [, paper, model = 1] = /^([\d.]+)(?::([\d.]+))?$/.exec(scale) ?? [];
  return paper / model > 0 ? (box.per * units[unit] * paper) / model : fitted(window, box);
}

function fitted(window, box) {
  const margin = (Number(state().margin) || 10) * box.per;
  const wide = window[2] - window[0],
    high = window[3] - window[1];
  const least = Math.min((box.width - 2 * margin) / wide, (box.height - 2 * margin) / high);
  return Number.isFinite(least) ? least : 1;
}

function paint(frame) {
  const box = layPaper(),
    dots = window.devicePixelRatio || 1,
    { pens: pen, hidden } = state();
  if (
    canvas.width !== Math.round(stage.clientWidth * dots) ||
    canvas.height !== Math.round(stage.clientHeight * dots)
  ) {
    canvas.width = Math.round(stage.clientWidth * dots);
    canvas.height = Math.round(stage.clientHeight * dots);
  }
  const [x0, y0, x1, y1] = frame.window;
  zoom ??= scaled(frame.window, box);
  const scale = zoom,
    context = canvas.getContext("2d");
  const middle = [box.x + box.width / 2 - ((x0 + x1) / 2) * scale, box.y + box.height / 2 + ((y0 + y1) / 2) * scale];
  context.setTransform(dots, 0, 0, dots, 0, 0);
  context.clearRect(0, 0, stage.clientWidth, stage.clientHeight);
  context.lineCap = "round";
  const starts = frame.count.reduce((list, some) => [...list, list.at(-1) + some], [0]);
  for (let c = classes.length - 1; c >= 0; c--) {
    // hidden lines lie below all others
    const name = classes[c],
      { lines } = frame;
    if (!pen[name].on) continue;
    context.beginPath();
    for (let i = 4 * starts[c]; i < 4 * starts[c + 1]; i += 4) {
      context.moveTo(middle[0] + lines[i] * scale, middle[1] - lines[i + 1] * scale);
      context.lineTo(middle[0] + lines[i + 2] * scale, middle[1] - lines[i + 3] * scale);
    }
    const width = Number(pen[name].width) * box.per;
    context.setLineDash(name === "hidden" && hidden === "dashed" ? [12 * width, 3 * width] : []);
    context.lineWidth = Math.max(width, 0.5);
    context.strokeStyle = pen[name].color;
    context.stroke();
  }
}

/* ---- frames ---- */

let wanted = false,
  drawing = false,
  isTurning = false,
  slow = false,
  restTimer;

/* Something has changed: a frame now, the page when nothing more changes. */
function changed({ turning = false } = {}) {
  if (!model?.ready) return showCommand();
  wanted = true;
  isTurning = turning;
  clearTimeout(restTimer);
  restTimer = setTimeout(rest, REST);
  if (!turning) zoom = undefined;
  if (!drawing) drawFrames();
  showCommand();
}

/* Asks for a frame if one is wanted. */
function nextFrame() {
  if (!wanted) return undefined;
  wanted = false;
  const now = state(),
    hidden = isTurning && slow ? "none" : now.hidden;
  const args = [...sceneArguments(now), ...lineArguments(now, scene, hidden), "--", now.name];
  return model.live.ask("draw", { args });
}

/* Draws frames as long as any is wanted. While one is painted, the worker draws the next. */
async function drawFrames() {
  const of = model;
  drawing = true;
  for (let coming = nextFrame(); coming; coming ??= nextFrame()) {
    const drawn = await coming;
    if (of !== model) return;
    coming = nextFrame();
    if (!drawn.count) {
      say(drawn.messages, true);
      continue;
    }
    slow = slow || drawn.ms > SLOW;
    scene = { centre: drawn.centre, diameter: drawn.diameter, bodies: drawn.bodies, faces: drawn.faces };
    await new Promise((resolve) => requestAnimationFrame(resolve));
    if (of !== model) return;
    stage.classList.add("turning");
    paint(drawn);
    stage.dataset.frames = Number(stage.dataset.frames ?? 0) + 1;
  }
  drawing = false;
}

/* The model rests: the program draws its page. */
let resting = 0;
async function rest() {
  if (drawing) {
    restTimer = setTimeout(rest, REST); // a frame that came later would cover the page
    return;
  }
  const of = model,
    turn = ++resting;
  by("busy").hidden = false;
  const done = await printed("svg");
  if (of !== model || turn !== resting) return;
  by("busy").hidden = true;
  say(done.messages, done.status !== 0);
  showCommand(done.status === 0);
  if (!done.bytes) return;
  const url = URL.createObjectURL(new Blob([done.bytes], { type: "image/svg+xml" }));
  URL.revokeObjectURL(still.src);
  still.src = url;
  still.alt = `Line drawing of ${of.name}`;
  await still.decode().catch(() => {});
  if (of !== model || turn !== resting || drawing) return;
  layPaper();
  zoom = undefined;
  stage.classList.remove("turning");
  canvas.getContext("2d").clearRect(0, 0, canvas.width, canvas.height);
  stage.dataset.state = "drawn";
}

/* What the program writes in this format. A drawing that nobody waits for any more is given up. */
let printing = 0;
async function printed(format, keep = false) {
  const now = state();
  if (printing > 0 && !keep && !model.saving) {
    model.printer.end();
    model.printer = helper(model);
    printing = 0;
  }
  const { printer } = model;
  printing++;
  const done = await printer.ask("run", {
    args: programArguments(now, scene, format),
    output: outputName(now.name, format).replace(/^\.\//, ""),
  });
  if (printer === model.printer) printing--;
  return done;
}

/* ---- the file ---- */

function helper({ file, materials, name, module }) {
  const one = new Helper();
  one.ask("load", { module, name, files: [...materials.map((other) => [other.name, other]), [name, file]] });
  return one;
}

/* Takes a file, and the materials of an OBJ, in place of the one before, whose workers end with all their memory. */
async function take(file, materials = []) {
  const name = file.name.replace(/[/\0]/g, "_") || "model";
  const own = { name, file, materials, module: await compiled, ready: false };
  for (const one of [model?.live, model?.printer]) one?.end();
  clearTimeout(restTimer);
  model = own;
  scene = zoom = undefined;
  slow = drawing = wanted = false;
  printing = 0;
  resting++;
  stage.dataset.state = "reading";
  stage.classList.remove("turning");
  canvas.getContext("2d").clearRect(0, 0, canvas.width, canvas.height);
  still.removeAttribute("src");
  still.alt = "";
  layPaper();
  by("about").textContent = `reading ${name} …`;
  say("");
  own.live = helper(own);
  own.printer = helper(own);
  await open(own);
}

async function open(own) {
  own.ready = false;
  stage.dataset.state = "reading";
  showCommand();
  const args = [...sceneArguments(state()), "--", own.name];
  const done = await own.live.ask("open", { args });
  if (own !== model) return;
  by("busy").hidden = true;
  if (done.status !== 0) {
    tellScene();
    by("about").textContent = `${own.name} is not drawn.`;
    stage.dataset.state = "failed";
    canvas.getContext("2d").clearRect(0, 0, canvas.width, canvas.height);
    still.removeAttribute("src");
    return say(done.messages, true);
  }
  own.ready = true;
  const first = await own.live.ask("draw", { args: [...sceneArguments(state()), "--", own.name] });
  if (own !== model) return;
  if (first.count) scene = { centre: first.centre, diameter: first.diameter, bodies: first.bodies, faces: first.faces };
  tellScene();
  changed();
}

/* Takes one model of the files that a user gives. Materials without a model are for the one that is there. */
function takeOwn(files) {
  const materials = [...files].filter((one) => /\.mtl$/i.test(one.name)),
    [file, ...more] = [...files].filter((one) => !materials.includes(one));
  if (more.length) return say("The page draws one model at a time.", true);
  if (file) by("model").value = "";
  if (file) take(file, materials);
  else if (materials.length && model) take(model.file, [...model.materials, ...materials]);
}

async function takeExample(name) {
  const answer = await fetch(`./models/${name}`);
  if (!answer.ok) return say(`The model ${name} is not on this server.`, true);
  take(new File([await answer.blob()], name));
}

by("file").addEventListener("change", (event) => {
  takeOwn(event.target.files);
  event.target.value = "";
});
by("model").addEventListener("change", (event) => takeExample(event.target.value));
addEventListener("dragover", (event) => {
  event.preventDefault();
  stage.classList.add("over");
});
addEventListener("dragleave", (event) => event.relatedTarget ?? stage.classList.remove("over"));
addEventListener("drop", (event) => {
  event.preventDefault();
  stage.classList.remove("over");
  takeOwn(event.dataTransfer.files);
});

/* ---- turning ---- */

function showAngles() {
  for (const name of ["azimuth", "elevation"]) controls.elements[name].value = Number(view[name].toFixed(1));
  showView();
}

function showView() {
  const flat = state().perspective === "0";
  for (const button of by("presets").children) {
    const { view: name } = button.dataset;
    button.disabled = !flat && oblique.includes(name);
    button.setAttribute("aria-pressed", name === view.view && !button.disabled);
  }
}

function turnTo(azimuth, elevation, name = "") {
  view.view = name;
  view.azimuth = ((azimuth % 360) + 360) % 360;
  view.elevation = Math.max(-90, Math.min(90, elevation));
  if (!name) for (const key of ["azimuth", "elevation"]) view[key] = Number(view[key].toFixed(1));
  showAngles();
}

let grip;
stage.addEventListener("pointerdown", (event) => {
  if (!event.isPrimary) grip = undefined; // two fingers look closer: the browser sees to that
  if (event.button !== 0 || !event.isPrimary) return;
  grip = { id: event.pointerId, x: event.clientX, y: event.clientY, ...view };
  stage.setPointerCapture(event.pointerId);
});
stage.addEventListener("pointermove", (event) => {
  if (event.pointerId !== grip?.id) return;
  const per = 180 / Math.max(200, Math.min(stage.clientWidth, stage.clientHeight)); // degrees for a pixel
  turnTo(grip.azimuth - (event.clientX - grip.x) * per, grip.elevation + (event.clientY - grip.y) * per);
  changed({ turning: true });
});
for (const name of ["pointerup", "pointercancel"])
  stage.addEventListener(name, (event) => {
    if (event.pointerId === grip?.id) grip = undefined;
  });

const keys = { ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] };
stage.addEventListener("keydown", (event) => {
  const by = keys[event.key],
    step = event.shiftKey ? 1 : 5;
  if (event.ctrlKey || event.altKey || event.metaKey || !(by || event.key === "Home")) return;
  event.preventDefault();
  if (by) turnTo(view.azimuth + by[0] * step, view.elevation + by[1] * step);
  else turnTo(...presets.iso, "iso");
  changed({ turning: true });
});

/* ---- controls ---- */

for (const [name, angles] of Object.entries(presets)) {
  const button = Object.assign(document.createElement("button"), { type: "button", textContent: name });
  button.dataset.view = name;
  button.addEventListener("click", () => {
    turnTo(...angles, name);
    changed();
  });
  by("presets").append(button);
}

for (const [name, width] of Object.entries(pens)) {
  const row = document.createElement("tr");
  row.innerHTML = `<th scope="row">${name}</th>
    <td><input type="checkbox" name="${name}-on" aria-label="${name}: drawn" checked></td>
    <td><input type="number" name="${name}-width" aria-label="${name}: width in mm" min="0.01" max="20" step="any"
      value="${width}"></td>
    <td><input type="color" name="${name}-color" aria-label="${name}: colour" value="#000000"></td>`;
  by("pens").append(row);
}

controls.addEventListener("submit", (event) => event.preventDefault());
controls.addEventListener("input", (event) => {
  const { name, value } = event.target;
  if (name === "azimuth" || name === "elevation") {
    const typed = Number(value); // nothing is 0
    view.view = "";
    view[name] = name === "azimuth" ? typed % 360 : Math.max(-90, Math.min(90, typed));
    if (Math.abs(typed) > event.target.max) event.target.value = view[name]; // what is drawn
  }
  showView();
  if (["hull", "rounded", "up"].includes(name) && model) return open(model);
  changed();
});
controls.addEventListener("change", showAngles);
controls.addEventListener("reset", () =>
  setTimeout(() => {
    turnTo(...presets.iso, "iso");
    if (model) open(model);
  }),
);

by("copy").addEventListener("click", async () => {
  const text = by("command").textContent;
  try {
    await navigator.clipboard.writeText(text);
    by("copy").textContent = "Copied";
  } catch {
    getSelection().selectAllChildren(by("command"));
    by("copy").textContent = "Selected";
  }
  setTimeout(() => (by("copy").textContent = "Copy"), 1500);
});

const types = {
  svg: "image/svg+xml",
  pdf: "application/pdf",
  dxf: "image/vnd.dxf",
  tikz: "text/x-tex",
  hpgl: "application/vnd.hp-hpgl",
};
for (const button of document.querySelectorAll("[data-format]"))
  button.addEventListener("click", async () => {
    const { format } = button.dataset,
      of = model;
    if (!of?.ready) return say("There is no drawing to save yet.", true);
    of.saving = true;
    const name = outputName(of.name, format).replace(/^\.\//, "");
    const done = await printed(format, true);
    of.saving = false;
    if (of !== model) return;
    say(done.messages, done.status !== 0);
    if (done.status !== 0 || !done.bytes) return;
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([done.bytes], { type: types[format] }));
    link.download = name;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  });

new ResizeObserver(() => {
  layPaper();
  if (stage.classList.contains("turning")) changed();
}).observe(stage);

showAngles();
layPaper();
compiled.then(
  () => takeExample(by("model").value),
  (error) => say(`The program cannot run here: ${error.message}`, true),
);

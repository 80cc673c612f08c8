/* The page in a headless Chromium, by real clicks, keys and drops.
 * node tests/web/page.js PROGRAM PAGE FOLDER: what is saved and said is compared with what the program does by the
 * command that the page shows. FOLDER is for files. */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import {
  copyFileSync,
  existsSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  renameSync,
  rmSync,
  statSync,
  writeFileSync,
} from "node:fs";
import path from "node:path";
import { gzipSync } from "node:zlib";
import { Browser, findBrowser, serve } from "./browser.js";

const program = path.resolve(process.argv[2]),
  page = process.argv[3],
  folder = path.resolve(process.argv[4]);
const MOST_BYTES = 1500000; // of the page, compressed
const LONGEST_GAP = 1500; // ms without a turn of the page's loop; a page that reads 100 MB itself stops for longer
const MORE_MEMORY = 60e6; // bytes of the page after a file of 100 MB, more than before it
const here = (name) => path.join(folder, name);

/* ---- what the page weighs ---- */

function files(of) {
  return readdirSync(of, { withFileTypes: true }).flatMap((one) =>
    one.isDirectory() ? files(path.join(of, one.name)) : [path.join(of, one.name)],
  );
}
const weight = files(page).reduce((sum, file) => sum + gzipSync(readFileSync(file)).length, 0);
assert.ok(weight < MOST_BYTES, `${weight} bytes, compressed`);

/* ---- files ---- */

const oddName = "it's a $odd  name.off";
copyFileSync("models/tower.off", here(oddName));
copyFileSync("models/table.off", here("table.off"));
writeFileSync(here("broken.off"), "OFF\n3 1 0\n0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n");
writeFileSync(here("colours.obj"), "mtllib colours.mtl\nusemtl red\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
writeFileSync(here("colours.mtl"), "newmtl red\nKd 1 0 0\n");
writeFileSync(here("m.stl.gz"), gzipSync("OFF\n"));
writeFileSync(here("words.stl"), "This is a letter, not a model.\n");
const many = 4500000;
writeFileSync(
  here("large.off"),
  `OFF\n${many + 3} 1 0\n0 0 0\n1 0 0\n0 1 0\n${"0.123456 0.234567 0.5\n".repeat(many)}3 0 1 2\n`,
);
assert.ok(statSync(here("large.off")).size > 95e6);
mkdirSync(here("bin"));
mkdirSync(here("saved"));
writeFileSync(here("bin/roberts"), `#!/bin/sh\nexec '${program}' "$@"\n`, { mode: 0o755 });

/* Runs a command of the page in a shell, where `roberts` is the program. */
function shell(command) {
  const done = spawnSync("sh", ["-c", command], {
    cwd: folder,
    env: { ...process.env, PATH: `${here("bin")}:${process.env.PATH}` },
  });
  return { status: done.status, messages: done.stderr.toString() };
}

const server = await serve(page),
  browser = new Browser(findBrowser(), here("profile"));
const wrong = [],
  asked = [];
let saved = 0; // files; one that is there may still be empty
browser.listeners.push(({ method, params }) => {
  if (method === "Runtime.exceptionThrown")
    wrong.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
  if (method === "Network.requestWillBeSent") asked.push(params.request.url);
  if (method === "Browser.downloadProgress" && params.state === "completed") saved++;
});

const text = (selector) => browser.evaluate(`document.querySelector("${selector}").textContent`);
const drawn = `document.querySelector("#stage").dataset.state === "drawn" && document.querySelector("#busy").hidden &&
  !document.querySelector("#stage").classList.contains("turning")`;
/* Until the page has drawn this, at rest. */
const rest = (command) =>
  browser.until(`${drawn} && document.querySelector("#command").textContent.includes(${JSON.stringify(command)})`);

async function save(format) {
  const before = saved;
  await browser.click(`[data-format=${format}]`);
  const end = Date.now() + 30000;
  while (saved === before) {
    assert.ok(Date.now() < end, `nothing was saved as ${format}`);
    await new Promise((resolve) => setTimeout(resolve, 30));
  }
  const [name] = readdirSync(here("saved"));
  renameSync(here(`saved/${name}`), here("saved.part"));
  return { name, bytes: readFileSync(here("saved.part")) };
}

/* Saves, and compares with what the command writes. */
async function compare(format) {
  const shown = await text("#command"),
    saved = await save(format);
  if ((await text("#command")) !== shown) return compare(format); // a key was still on its way
  const command = shown.replace(/\.svg('?)$/, `.${format}$1`),
    done = shell(command);
  assert.equal(done.status, 0, `${command}: ${done.messages}`);
  const output = readdirSync(folder).find((name) => name.endsWith(`.${format}`));
  assert.ok(output, `no output of ${command}`);
  assert.ok(readFileSync(here(output)).equals(saved.bytes), `other bytes: ${command}`);
  rmSync(here(output));
  return command;
}

async function choose(name, presses) {
  await browser.evaluate(
    `(() => { const e = document.querySelector("[name=${name}]"); e.scrollIntoView(); e.focus(); })()`,
  );
  for (let i = 0; i < Math.abs(presses); i++) await browser.key(presses > 0 ? "ArrowDown" : "ArrowUp");
}

try {
  await browser.send("Browser.setDownloadBehavior", {
    behavior: "allow",
    downloadPath: here("saved"),
    eventsEnabled: true,
  });
  await browser.open(server.address);
  await browser.send("Network.enable");

  // the model that is there at first
  await rest("roberts table.off -o table.svg");
  await compare("svg");
  const answers = await browser.evaluate(`Promise.all([...document.querySelectorAll("#model option")].map(
    async ({ value }) => value === "" || (await fetch("models/" + value)).ok))`);
  assert.deepEqual(answers, Array(13).fill(true)); // twelve models, and the place of the user's own
  const first = await browser.picture();

  // turned by the mouse, by a finger, by keys
  await browser.drag("#stage", 100, 20);
  await rest("--azimuth=");
  assert.notDeepEqual(await browser.picture(), first);
  await compare("svg");
  const angles = await text("#command");
  await browser.touch("#stage", [[0, 0]], [[80, 40]]);
  await browser.until(`${drawn} && document.querySelector("#command").textContent !== ${JSON.stringify(angles)}`);
  await compare("svg");
  await browser.evaluate(`document.querySelector("#stage").focus()`);
  await browser.key("Home");
  await rest("roberts table.off");
  await browser.key("ArrowLeft");
  await browser.key("ArrowUp", 8); // with Shift
  await rest("--azimuth=50 --elevation=36.3");

  // by the keyboard alone, from the file to the views
  await browser.evaluate(`document.querySelector("#file").focus()`);
  const way = ["model", "stage", "svg", "pdf", "dxf", "tikz", "hpgl", "copy", "iso", "dimetric"];
  for (const expected of way) {
    await browser.key("Tab");
    const at = `(({ id, dataset }) => id || dataset.format || dataset.view)(document.activeElement)`;
    assert.equal(await browser.evaluate(at), expected);
  }
  await browser.key("Enter");
  await rest("--view=dimetric");

  // light and dark
  const ground = () => browser.evaluate("getComputedStyle(document.documentElement).backgroundColor");
  const light = await ground();
  await browser.send("Emulation.setEmulatedMedia", { features: [{ name: "prefers-color-scheme", value: "dark" }] });
  assert.notEqual(await ground(), light);

  // turned at a scale, it is as small as the page says
  const type = (name, value) =>
    browser.evaluate(`(() => { const e = document.querySelector("[name=${name}]"); e.value = "${value}";
      e.dispatchEvent(new Event("input", { bubbles: true })); })()`);
  const wide = `(() => { const { width, height } = document.querySelector("#canvas");
    const dots = document.querySelector("#canvas").getContext("2d").getImageData(0, 0, width, height).data;
    const x = [...dots.keys()].filter((i) => i % 4 === 3 && dots[i]).map((i) => (i >> 2) % width);
    return x.reduce((a, b) => Math.max(a, b), 0) - x.reduce((a, b) => Math.min(a, b), width); })()`;
  await type("scale", "1:10");
  await rest("--scale=1:10");
  // a frame is soon replaced by the page, so it is measured as soon as it is painted
  await browser.evaluate(`(() => { const stage = document.querySelector("#stage");
    window.widths = [];
    window.measuring = new MutationObserver(() => window.widths.push(${wide}));
    window.measuring.observe(stage, { attributes: true, attributeFilter: ["data-frames"] });
    stage.focus(); })()`);
  await browser.key("ArrowLeft");
  await browser.until("window.widths.length > 0");
  const widths = await browser.evaluate("window.measuring.disconnect(), window.widths");
  assert.ok(
    widths.every((dots) => dots > 2 && dots < 40),
    `${widths}`,
  );
  await type("scale", "1:x");
  await browser.until(`document.querySelector("#messages").textContent.includes("--scale") &&
    document.querySelector("#command").textContent === ""`);
  assert.ok(!(await text("#messages")).includes("--help"));
  await type("scale", "");
  await rest("roberts --azimuth");

  // a model whose y axis points up is stood up, and then seen in all views of the program
  await choose("up", 1);
  for (const name of ["cavalier", "dimetric", "top"]) {
    await browser.click(`[data-view=${name}]`);
    await rest(`roberts --y-up --view=${name} table.off`);
    await compare("svg");
  }
  await choose("perspective", 2);
  await rest("--y-up --eye=");
  await compare("svg");

  // oblique views have no perspective
  const buttons = (which) => browser.evaluate(`[...document.querySelectorAll("#presets button")]
    .filter((button) => ${which}).map((button) => button.dataset.view).join()`);
  const lit = `button.getAttribute("aria-pressed") === "true"`;
  assert.equal(await buttons("button.disabled"), "cavalier,cabinet");
  assert.equal(await buttons(lit), "top");
  await choose("perspective", -2);
  await browser.click("[data-view=cabinet]");
  await rest("--y-up --view=cabinet");
  assert.equal(await buttons(lit), "cabinet");
  await choose("perspective", 1);
  await rest("--eye=");
  assert.equal(await buttons(lit), "");
  await browser.evaluate(`document.querySelector("[type=reset]").click()`);
  await rest("roberts table.off");

  // an angle beyond its range is shown as it is drawn, and no angle is 0
  const angle = (name) => browser.evaluate(`document.querySelector("[name=${name}]").value`);
  await type("azimuth", 400);
  await type("elevation", 95);
  await rest("--azimuth=40 --elevation=90");
  assert.deepEqual([await angle("azimuth"), await angle("elevation")], ["40", "90"]);
  await type("azimuth", "");
  await rest("--azimuth=0 --elevation=90");
  assert.equal(await text("#messages"), "");
  await browser.evaluate(`document.querySelector("[name=azimuth]")
    .dispatchEvent(new Event("change", { bubbles: true }))`);
  assert.equal(await angle("azimuth"), "0");

  // a file that is dropped, and the controls
  await browser.drop("#stage", here(oddName));
  await rest("odd  name");
  await browser.click("[data-view=trimetric]");
  await choose("hidden", 1);
  await choose("fill", 2);
  await browser.click("[name=union]");
  await browser.click("[name=landscape]");
  await browser.evaluate(`document.querySelector("details").open = true`);
  await browser.click("[name=crease-on]");
  await rest("--view=trimetric --hidden=dashed --union --fill=body --landscape --style=crease:off");
  for (const format of ["svg", "pdf", "dxf", "tikz", "hpgl"]) await compare(format);
  await browser.click("[name=rounded]");
  await rest("--rounded");
  await choose("perspective", 2);
  await rest("--eye=");
  const last = await compare("svg");
  assert.ok(last.includes("'it'\\''s a $odd  name.off'"), last);

  // materials of an OBJ: together with it, or after it
  await browser.evaluate(`document.querySelector("[type=reset]").click()`);
  await choose("fill", 1);
  const silent = `document.querySelector("#messages").textContent === ""`;
  await browser.drop("#stage", here("colours.mtl"), here("colours.obj"));
  await rest("--fill=model colours.obj");
  await browser.until(silent);
  await compare("svg");
  await browser.drop("#stage", here("colours.obj"));
  await browser.until(`${drawn} && document.querySelector("#messages").textContent.includes("no effect")`);
  await browser.drop("#stage", here("colours.mtl"));
  await browser.until(`${drawn} && ${silent}`);
  await compare("svg");

  // two models are refused, and the one that is there stays
  await browser.drop("#stage", here("table.off"), here("colours.obj"));
  await browser.until(`document.querySelector("#messages").textContent.includes("one model at a time")`);
  await compare("svg");

  // what is wrong is said in the words of the program
  for (const name of ["broken.off", "words.stl", "m.stl.gz"]) {
    await browser.drop("#stage", here(name));
    await browser.until(`document.querySelector("#about").textContent === "${name} is not drawn."`);
    const said = await text("#messages"),
      done = shell(`roberts ${name}`);
    assert.equal(done.status, 1);
    assert.equal(said, done.messages);
    if (name.endsWith(".gz")) assert.ok(said.includes("gzip -dc m.stl.gz | roberts -"), said);
    assert.equal(await text("#command"), "");
    await browser.click("[name=frame]");
    assert.equal(await text("#command"), "");
  }

  // a large file does not stop the page, and leaves it and its memory as they were
  await browser.evaluate(`document.querySelector("[type=reset]").click()`);
  await browser.evaluate(`window.gap = 0; let last = performance.now();
    setInterval(() => { gap = Math.max(gap, performance.now() - last); last = performance.now(); }, 10); 0`);
  await browser.drop("#stage", here("table.off"));
  await rest("roberts table.off -o table.svg");
  const before = await browser.memory();
  await browser.drop("#stage", here("large.off"));
  await browser.until(`document.querySelector("#about").textContent.includes("1 face") && ${drawn}`, 120);
  const gap = await browser.evaluate("gap"),
    most = await browser.memory();
  assert.ok(gap < LONGEST_GAP, `the page stood still for ${gap} ms`);
  await browser.drop("#stage", here("table.off"));
  await rest("roberts table.off -o table.svg");
  await compare("svg");
  let after = await browser.memory();
  for (let i = 0; i < 100 && after > before + MORE_MEMORY; i++) {
    await new Promise((resolve) => setTimeout(resolve, 100));
    after = await browser.memory();
  }
  assert.ok(most > before + 96e6, `${most} bytes with the large file, ${before} before`);
  assert.ok(after < before + MORE_MEMORY, `${after} bytes after the large file, ${before} before`);

  // two fingers look closer, and do not turn
  const still = await text("#command");
  await browser.touch("#stage", [[-40, 0], [40, 0]], [[-120, 0], [120, 0]]);
  await browser.until("visualViewport.scale > 1.5");
  assert.equal(await text("#command"), still);

  // each control has a name for a screen reader, and nobody else was asked for anything
  const { nodes } = await browser.send("Accessibility.getFullAXTree");
  const unnamed = nodes.filter(
    (node) =>
      !node.ignored &&
      !node.name?.value &&
      node.properties?.some((one) => one.name === "focusable" && one.value.value) &&
      node.role.value !== "RootWebArea",
  );
  assert.deepEqual(
    unnamed.map((node) => node.role.value),
    [],
  );
  const foreign = asked.filter((url) => !url.startsWith(server.address) && !/^(blob|data):/.test(url));
  assert.deepEqual(foreign, []);
  assert.deepEqual(wrong, []);
  console.log(
    `note: ${Math.round(weight / 1000)} kB, compressed; with 100 MB it paused for ${Math.round(gap)} ms at most, and ` +
      `took ${[before, most, after].map((bytes) => Math.round(bytes / 1e6)).join(", ")} MB before, with and after it`,
  );
} catch (error) {
  if (existsSync(folder)) writeFileSync(here("page.png"), await browser.picture());
  console.error(
    `command: ${await text("#command")}\nabout: ${await text("#about")}\nsaid: ${await text("#messages")}\n` +
      `state: ${await browser.evaluate(`document.querySelector("#stage").dataset.state`)}\nscript: ${wrong.join("\n")}`,
  );
  throw error;
} finally {
  await browser.end();
  server.end();
}

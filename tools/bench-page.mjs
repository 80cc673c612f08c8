/* Frames per second of the page in headless Chromium: node tools/bench-page.mjs [BUILD] (default: build)
 *
 * Needs `make web tools`. Each scene is turned for some seconds by a mouse that moves 120 times a second. The table
 * gives the frames that the page painted in a second; how often the browser could have shown one (60 times at most);
 * and the processor time for each painted frame, in ms: of the page with its worker, and of the process that composes
 * the picture. */
import { spawnSync } from "node:child_process";
import { mkdtempSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { Browser, findBrowser, serve } from "../tests/web/browser.js";

const build = path.resolve(process.argv[2] ?? "build"),
  seconds = 6;
const scenes = [
  ["lattice", "lattice", 10, "none"],
  ["lattice, hidden lines too", "lattice", 10, "dashed"],
  ["scan", "scan", 75000, "none"],
];
const drawn = `document.querySelector("#stage").dataset.state === "drawn"`;
const folder = mkdtempSync(path.join(tmpdir(), "bench-page-"));
const server = await serve(`${build}/web/page`),
  browser = new Browser(findBrowser(), path.join(folder, "profile"));

const wait = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/* Seconds of the processor until now, by kind of process. */
async function used() {
  const sum = {};
  for (const { type, cpuTime } of await browser.processes()) sum[type] = (sum[type] ?? 0) + cpuTime;
  return sum;
}

/* Frames that the page has painted, and times that the browser was ready for one, until now. */
async function state() {
  const [painted, ready, ms] = await browser.evaluate(
    `[Number(document.querySelector("#stage").dataset.frames ?? 0), window.ready, performance.now()]`,
  );
  return { painted, ready, ms, cpu: await used() };
}

/* Turns the model round and round by the mouse, which moves until `stop()`. */
async function turn(stop) {
  const at = await browser.place("#stage"),
    begin = performance.now();
  await browser.mouse("mousePressed", at, 1);
  while (!stop()) {
    const t = (performance.now() - begin) / 1000;
    browser.mouse("mouseMoved", { x: at.x + 200 * Math.sin(t), y: at.y + 60 * Math.cos(t) }, 1);
    await wait(1000 / 120);
  }
  await browser.mouse("mouseReleased", at);
}

console.log("scene                      painted/s  ready/s  page ms  composer ms");
try {
  await browser.open(server.address);
  await browser.until(drawn);
  await browser.evaluate(`window.ready = 0; const count = () => { ready++; requestAnimationFrame(count); }; count()`);
  for (const [name, family, size, hidden] of scenes) {
    const file = path.join(folder, `${family}.off`);
    writeFileSync(file, spawnSync(`${build}/tools/make-models`, [family, String(size)], { maxBuffer: 1 << 29 }).stdout);
    await browser.evaluate(`document.querySelector("[name=hidden]").value = "${hidden}"`);
    await browser.drop("#stage", file);
    await browser.until(`${drawn} && document.querySelector("#about").textContent.includes("${family}.off:")`);
    let stop = false;
    const turning = turn(() => stop);
    await wait(1000);
    const first = await state();
    await wait(1000 * seconds);
    const last = await state();
    stop = true;
    await turning;
    const painted = last.painted - first.painted,
      passed = (last.ms - first.ms) / 1000;
    const cells = [painted / passed, (last.ready - first.ready) / passed].concat(
      ["renderer", "GPU"].map((kind) => (1000 * (last.cpu[kind] - first.cpu[kind])) / painted),
    );
    console.log(name.padEnd(26) + cells.map((cell, i) => cell.toFixed(1).padStart([10, 9, 9, 13][i])).join(""));
  }
} finally {
  await browser.end();
  server.end();
  rmSync(folder, { recursive: true });
}

/* Frames per second of the page's drawing, without the page: node tools/bench-web.mjs [BUILD] (default: build)
 *
 * Needs `make web tools`. Each scene is turned by 3.3 degrees a frame; the table gives the middle of 60 frames. */
import { spawnSync } from "node:child_process";
import { readFileSync } from "node:fs";
import path from "node:path";
import { pathToFileURL } from "node:url";

const build = path.resolve(process.argv[2] ?? "build"),
  frames = 60;
const { Live } = await import(pathToFileURL(`${build}/web/npm/live.js`));
const module = new WebAssembly.Module(readFileSync(`${build}/web/npm/roberts.wasm`));
const scenes = [
  ["scan", "scan", 75000, []],
  ["scan, all edges", "scan", 75000, ["--all-edges"]],
  ["scan, hidden lines too", "scan", 75000, ["--hidden=dashed"]],
  ["scan, perspective", "scan", 75000, ["--eye=-5e6,-9e6,4e6"]],
  ["scan", "scan", 350000, []],
  ["lattice", "lattice", 10, []],
  ["lattice, hidden lines too", "lattice", 10, ["--hidden=dashed"]],
  ["city, as one", "city", 16, ["--union"]],
];

function now() {
  return performance.now();
}

console.log("scene                          faces  segments  open ms  frame ms  frames/s   MB");
for (const [name, family, size, options] of scenes) {
  const made = spawnSync(`${build}/tools/make-models`, [family, String(size)], { maxBuffer: 1 << 29 });
  const live = new Live(module, { "model.off": made.stdout });
  let begin = now();
  const opened = live.open(["--", "model.off"]),
    open = now() - begin,
    times = [];
  if (opened.status !== 0) throw new Error(opened.messages);
  let last;
  for (let i = 0; i < frames; i++) {
    const view = options.some((one) => one.startsWith("--eye"))
      ? [`--roll=${i}`]
      : [`--azimuth=${3.3 * i}`, "--elevation=25"];
    begin = now();
    last = live.draw([...options, ...view, "--", "model.off"]);
    times.push(now() - begin);
    if (!last.count) throw new Error(last.messages);
  }
  const middle = times.sort((a, b) => a - b)[frames / 2];
  const cells = [
    last.faces,
    last.lines.length / 4,
    open.toFixed(0),
    middle.toFixed(1),
    (1000 / middle).toFixed(0),
    live.exports.memory.buffer.byteLength >> 20,
  ].map(String);
  console.log(name.padEnd(26) + cells.map((cell, i) => cell.padStart([10, 10, 9, 10, 10, 5][i])).join(""));
}

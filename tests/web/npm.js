/* The npm package against the program: the same bytes, the same messages, the same status. Draws every small model of
 * the folders in several ways: node --expose-gc tests/web/npm.js PROGRAM PACKAGE FOLDER... */
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, readdirSync, rmSync, statSync } from "node:fs";
import { tmpdir } from "node:os";
import path from "node:path";
import { pathToFileURL } from "node:url";

const [program, folder, ...models] = process.argv.slice(2);
const { draw, save, toArguments, RobertsError } = await import(pathToFileURL(path.resolve(folder, "index.js")));
const LARGEST = 40000; // bytes of a model
const MOST_MEMORY = 100e6; // bytes; one large drawing takes 28e6
const CASES = [
  ["svg", { hidden: "dashed", azimuth: 33.7, elevation: 21.3 }],
  ["svg", { eye: [9, 8, 7], union: true, group: "element" }],
  ["pdf", { fill: "body", hatch: "on", hull: true }],
  ["dxf", { label: "vertices", dash: "real", hidden: "dashed" }],
  ["tikz", { sheet: "first", landscape: true, dimensions: "overall" }],
  ["csv", { azimuth: 123.4, elevation: -12.5, hidden: "solid" }],
  ["hpgl", { view: "cabinet", allEdges: true }],
];

/* What the program writes for these drawings, each from its file's folder. One shell runs them all: to start a program
 * from node takes longer than to draw. */
function program_draws(drawings) {
  const here = mkdtempSync(path.join(tmpdir(), "roberts-npm-")),
    quoted = (word) => `'${word.replaceAll("'", "'\\''")}'`,
    lines = drawings.map(({ file, format, options }, i) => {
      const args = [...toArguments(options), "-f", format, "--", path.basename(file)].map(quoted).join(" ");
      const output = quoted(path.join(here, `${i}`)),
        command = `cd ${quoted(path.dirname(file))} && exec ${quoted(path.resolve(program))} ${args}`;
      return `(${command}) >${output} 2>${output}.said; echo $? >${output}.status`;
    });
  try {
    spawnSync("sh", { input: lines.join("\n") });
    return drawings.map((_, i) => ({
      status: Number(readFileSync(path.join(here, `${i}.status`))),
      bytes: readFileSync(path.join(here, `${i}`)),
      messages: readFileSync(path.join(here, `${i}.said`), "utf8")
        .split("\n")
        .filter((line) => line),
    }));
  } finally {
    rmSync(here, { recursive: true });
  }
}

async function package_draws(file, format, options) {
  const name = path.basename(file);
  try {
    const { bytes, warnings } = await save(readFileSync(file), format, { ...options, name });
    return { status: 0, bytes: Buffer.from(bytes), messages: warnings };
  } catch (error) {
    if (!(error instanceof RobertsError)) throw error;
    return { status: error.status, bytes: Buffer.alloc(0), messages: error.message.split("\n") };
  }
}

const drawings = models
  .flatMap((one) => readdirSync(one).map((name) => path.join(one, name)))
  .filter((file) => /\.(off|stl|obj|ply)$/.test(file) && statSync(file).size <= LARGEST)
  .map((file, i) => ({ file, format: CASES[i % CASES.length][0], options: CASES[i % CASES.length][1] }));
const all_expected = program_draws(drawings);
for (const [i, { file, format, options }] of drawings.entries()) {
  const expected = all_expected[i],
    got = await package_draws(file, format, options);
  const what = `${file} as ${format} with ${toArguments(options).join(" ")}`;
  assert.equal(got.status, expected.status, what);
  assert.deepEqual(got.messages, expected.messages, what);
  assert.ok(got.bytes.equals(expected.bytes), `other bytes: ${what}`);
}
assert.ok(drawings.length >= 50, `only ${drawings.length} models`);

const cube = readFileSync("models/table.off");
const bare = (drawing) => drawing.svg.replace(/<(title|desc)>.*?<\/\1>/g, "");
const { svg, warnings } = await draw(cube, { name: "table.off" });
assert.ok(svg.startsWith("<?xml") && svg.includes("<title>table.off</title>"));
assert.deepEqual(warnings, []);
await assert.rejects(draw(new TextEncoder().encode("OFF\n3 1 0\n0 0 x\n")), {
  status: 1,
  message: /model:3: z of vertex 0/,
});
await assert.rejects(draw(cube, { hiden: "dashed" }), {
  status: 2,
  message: /--hiden is unknown; did you mean --hidden\?/,
});
await assert.rejects(draw(cube, { page: "a9" }), (error) => !/--help/.test(error.message));
for (const wrong of ["table.off", undefined, cube.buffer])
  await assert.rejects(draw(wrong), {
    name: "TypeError",
    message: "model: the bytes of a file have to be a Uint8Array",
  });
for (const [option, value] of Object.entries({ format: "png", output: "a.svg", help: true, version: true }))
  await assert.rejects(draw(cube, { [option]: value }), {
    name: "TypeError",
    message: new RegExp(`^${option} is no option here: `),
  });
await assert.rejects(draw(cube, { name: "-" }), { name: "TypeError", message: /^name: "-" would be standard input/ });
const turned = await draw(cube, { help: false, output: "turn-%d.svg", turntable: 2 });
assert.deepEqual([turned.svg, Object.keys(turned.files)], ["", ["turn-0.svg", "turn-1.svg"]]);
const rooms = { roomFor: ["a.off", "b.off"], files: { "a.off": cube, "b.off": readFileSync("models/tower.off") } };
assert.deepEqual(toArguments(rooms), ["--room-for=a.off", "--room-for=b.off"]);
assert.notEqual(bare(await draw(cube, rooms)), bare(await draw(cube)));
await assert.rejects(save(cube, "png"), { status: 2, message: /PNG is not written here/ });

// parts need a file of their own; batches need processes, which are not here
const part = await save(cube, "svg", { name: "table.off", part: "1/1" }),
  [drawn] = program_draws([{ file: "models/table.off", format: "svg", options: { part: "1/1" } }]);
assert.ok(Buffer.from(part.bytes).equals(drawn.bytes));
assert.equal(bare(await draw(part.bytes, { join: true })), bare(await draw(cube)));
await assert.rejects(save(cube, "svg", { join: true }), { status: 1, message: /model: this is no part of a drawing/ });
await assert.rejects(save(cube, "svg", { batch: "drawings" }), { status: 2, message: /--batch needs processes/ });

// the memory of one drawing is given back before the next
const row = "0.123456 0.234567 0.5\n",
  many = 400000,
  large = new TextEncoder().encode(`OFF\n${many + 3} 1 0\n0 0 0\n1 0 0\n0 1 0\n${row.repeat(many)}3 0 1 2\n`);
let most = 0;
for (let i = 0; i < 12; i++) {
  globalThis.gc();
  await draw(i % 2 ? cube : large);
  most = Math.max(most, process.memoryUsage().external);
}
assert.ok(most > 24 * many, `${most} bytes are less than the vertices take`);
assert.ok(most < MOST_MEMORY, `${most} bytes after all drawings`);

// an option without its value takes no other argument for it
for (const [name, value] of [
  ["crease", true],
  ["labelSize", true],
  ["label", [true, "faces"]],
])
  await assert.rejects(draw(cube, { sheet: "first", [name]: value }), {
    status: 2,
    message: new RegExp(`^roberts: ${name} needs a value other than true$`, "m"),
  });
for (const [name, value] of [
  ["style", { crease: { width: 1 } }],
  ["style", ["hidden:off", { crease: "off" }]],
  ["eye", { x: 1, y: 2, z: 3 }],
])
  await assert.rejects(draw(cube, { [name]: value }), {
    name: "TypeError",
    message: `${name}: a value has to be a text or a number, as the program takes it; this is an object`,
  });
assert.deepEqual(toArguments({ hatch: true, hidden: true, frame: true }), ["--hatch=on", "--hidden=dashed", "--frame"]);

// files that options write
const { files } = await draw(cube, { name: "table.off", regions: "regions.json" });
assert.deepEqual(Object.keys(files), ["regions.json"]);
const regions = spawnSync(path.resolve(program), ["-f", "null", "--regions", "-", "models/table.off"]).stdout;
assert.ok(regions.length > 0 && Buffer.from(files["regions.json"]).equals(regions));
assert.deepEqual((await save(cube, "csv", { files: { "unused.mtl": new Uint8Array(0) } })).files, {});

// names with folders
const text = new TextEncoder();
for (const name of ["models/table.off", "./table.off", "/home/table.off"]) {
  const named = await draw(cube, { name });
  assert.deepEqual([bare(named), named.files], [bare({ svg }), {}], name);
}
const painted = await draw(text.encode("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n"), {
  name: "some/a.obj",
  files: { "some/a.mtl": text.encode("newmtl m\nKd 0 1 0\n") },
  fill: "model",
});
assert.ok(painted.svg.includes('fill="#00ff00"'));
await assert.rejects(draw(cube, { regions: "no/regions.json" }), { message: /No such file or directory/ });
await assert.rejects(draw(cube, { labels: "x.csv" }), { message: "roberts: x.csv: there is no such file in `files`" });
await assert.rejects(draw(cube, { turntable: 3 }), { message: /needs a name .*: output: "turn-%03d.svg"/ });

assert.deepEqual(toArguments({ allEdges: true, quiet: false, style: ["hidden:off", "wire:off"], eye: [1, 2, 3] }), [
  "--all-edges",
  "--style=hidden:off",
  "--style=wire:off",
  "--eye=1,2,3",
]);
assert.deepEqual(toArguments({ label: ["vertices", "faces"], field: ["owner=A"], pick: ["0,0", "1,1"], hatch: [] }), [
  "--label=vertices,faces",
  "--field=owner=A",
  "--pick=0,0",
  "--pick=1,1",
]);
console.log(`note: ${drawings.length} models, the same bytes as the program's`);

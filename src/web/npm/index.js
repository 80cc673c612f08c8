/* index.js - the npm package: a drawing of a model in memory, by the program itself. */
import { run } from "./program.js";

export class RobertsError extends Error {
  constructor(message, status) {
    super(message);
    this.name = "RobertsError";
    this.status = status;
  }
}

let loading;

/* The compiled module. It is compiled once; every drawing has an instance, and so a memory, of its own. */
function load() {
  loading ??= (async () => {
    const url = new URL("./roberts.wasm", import.meta.url);
    if (url.protocol !== "file:") {
      const answer = await fetch(url);
      if (!answer.ok) throw new Error(`${url}: ${answer.status} ${answer.statusText}`);
      return WebAssembly.compile(await answer.arrayBuffer());
    }
    const { readFile } = await import(/* webpackIgnore: true */ "node:fs/promises");
    return WebAssembly.compile(await readFile(url));
  })();
  loading.catch(() => (loading = undefined));
  return loading;
}

const notOptions = new Set(["name", "files"]);

/* Options of the program that would leave the result without its drawing. */
const notHere = {
  format: "draw() gives SVG, and save() takes the format as an argument",
  output: "the drawing is in the result; only a name for several files, as turn-%d.svg or %s.csv, can be given",
  help: "it draws nothing",
  version: "it draws nothing",
};

/* What `true` means for options that need a value. */
const usual = { hatch: "on", hidden: "dashed" };

function argument(name, value) {
  if (typeof value === "object")
    throw new TypeError(`${name}: a value has to be a text or a number, as the program takes it; this is an object`);
  const long = name.replace(/[A-Z]/g, (letter) => `-${letter.toLowerCase()}`),
    given = value === true ? usual[name] : value;
  return given === undefined ? `--${long}` : `--${long}=${given}`;
}

/* Options that may be given several times; of any other only the last one would count. */
const repeated = new Set(["style", "field", "pick", "roomFor"]);

/* A list of numbers is one value (a point), and so is a list of texts and numbers if the option is given but once. Any
 * other list is an option given several times. */
function values(name, value) {
  if (value === undefined || value === null || value === false) return [];
  if (!Array.isArray(value) || value.length === 0) return [value].flat();
  const kinds = repeated.has(name) ? ["number"] : ["number", "string"];
  return value.every((one) => kinds.includes(typeof one)) ? [value.join(",")] : value;
}

export function toArguments(options = {}) {
  return Object.entries(options)
    .filter(([name]) => !notOptions.has(name))
    .flatMap(([name, value]) => values(name, value).map((one) => argument(name, one)));
}

/* What the program says, of an option as it is called here. */
function inOptions(message) {
  return message
    .replace(/--([\w-]+) needs a value, but .*/, (_, long) => {
      const name = long.replace(/-./g, (part) => part[1].toUpperCase());
      return `${name} needs a value other than true`;
    })
    .replace(/-o (\S*%\S*)/g, 'output: "$1"')
    .replace(/^(roberts: [^:]*): No such file or directory$/gm, "$1: there is no such file in `files`");
}

export async function save(bytes, format, options = {}) {
  for (const [option, why] of Object.entries(notHere))
    if (values(option, options[option]).some((value) => option !== "output" || !/%(0?\d*d|s)/.test(value)))
      throw new TypeError(`${option} is no option here: ${why}`);
  const name = options.name ?? "model";
  if (name === "-") throw new TypeError('name: "-" would be standard input, which is empty');
  const files = { ...options.files, [name]: bytes };
  for (const [file, content] of Object.entries(files))
    if (!(content instanceof Uint8Array)) throw new TypeError(`${file}: the bytes of a file have to be a Uint8Array`);
  const module = await load();
  const args = [...toArguments(options), `--format=${format}`, "--", name];
  const done = run(module, args, files);
  const lines = done.messages.split("\n").filter((line) => line !== "");
  if (done.status !== 0) throw new RobertsError(inOptions(lines.join("\n")), done.status);
  return { bytes: done.output, warnings: lines, files: done.system.added() };
}

export async function draw(bytes, options = {}) {
  const { bytes: svg, ...others } = await save(bytes, "svg", options);
  return { svg: new TextDecoder().decode(svg), ...others };
}

/* program.js - the program itself, run on files in memory. */
import { Exit, System } from "./wasi.js";

/* An instance of the module with its system. */
export function start(module, files) {
  const system = new System(files);
  const instance = new WebAssembly.Instance(module, system.imports());
  system.bind(instance);
  instance.exports._initialize();
  return { system, exports: instance.exports };
}

/* Calls use(argc, argv) with the arguments in the memory of the instance, which keeps them. */
export function withArguments(exports, args, use) {
  const bytes = args.map((text) => new TextEncoder().encode(`${text}\0`));
  const size = 4 * (args.length + 1);
  const at = exports.malloc(bytes.reduce((sum, one) => sum + one.length, size));
  const view = new DataView(exports.memory.buffer);
  let next = at + size;
  bytes.forEach((one, i) => {
    view.setUint32(at + 4 * i, next, true);
    new Uint8Array(exports.memory.buffer, next, one.length).set(one);
    next += one.length;
  });
  view.setUint32(at + 4 * args.length, 0, true);
  return use(args.length, at);
}

/* Runs the program with these arguments. Returns its exit status, its messages, its standard output, and its files. */
export function run(module, args, files = {}) {
  const { system, exports } = start(module, files);
  let status;
  try {
    status = withArguments(exports, ["roberts", ...args], exports.__main_argc_argv);
  } catch (error) {
    if (!(error instanceof Exit) && !(error instanceof WebAssembly.RuntimeError)) throw error;
    status = error.code ?? 1;
    if (!(error instanceof Exit))
      return { status, messages: `${system.messages}roberts: ${error.message}\n`, output: system.output, system };
  }
  return { status, messages: system.messages, output: system.output, system };
}

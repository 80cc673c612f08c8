/* worker.js - runs beside the page: draws frames of one scene, or whole pages by the program. */
import { Live } from "./live.js";
import { run } from "./program.js";

let module, name, files, live;

const handlers = {
  /* Takes the module and the files, of which one has the name of the model. */
  async load(message) {
    ({ module, name } = message);
    files = {};
    for (const [one, file] of message.files) files[one] = new Uint8Array(await file.arrayBuffer());
    return {};
  },

  /* Builds the scene, in an instance of its own. */
  open({ args }) {
    live = undefined; // so that its memory may go before the next is taken
    live = new Live(module, files);
    return live.open(args);
  },

  draw({ args }) {
    const begin = performance.now();
    const frame = live.draw(args);
    return { ...frame, ms: performance.now() - begin };
  },

  run({ args, output }) {
    const done = run(module, args, files);
    return { status: done.status, messages: done.messages, bytes: done.system.bytes(output)?.slice() };
  },
};

/* One after the other, also those that wait. */
let before = Promise.resolve();
onmessage = ({ data }) => {
  before = before.then(async () => {
    try {
      const result = await handlers[data.kind](data);
      postMessage({ id: data.id, ...result }, [result.lines?.buffer, result.bytes?.buffer].filter(Boolean));
    } catch (error) {
      const why =
        error instanceof RangeError || /memory|unreachable/i.test(error.message) ? "not enough memory" : error;
      postMessage({ id: data.id, status: 1, messages: `roberts: ${name}: ${why}\n` });
    }
  });
};

/* live.js - a scene that is drawn again and again, as segments: live.c in the module. */
import { start, withArguments } from "./program.js";

/* Classes of lines, in the order of a frame. */
export const classes = ["outline", "crease", "crease", "border", "wire", "intersection", "outline", "hidden"];

/* Where the members of live_frame lie. */
const AT = { window: 32, line: 64, bodies: 68, faces: 72, centre: 80, diameter: 104 };

/* One file's scene, in an instance of its own: with the instance its memory goes. */
export class Live {
  constructor(module, files) {
    Object.assign(this, start(module, files));
  }

  /* Calls a function of the module; returns its result and what it said meanwhile. */
  call(name, args) {
    const said = this.system.messages.length;
    const result = withArguments(this.exports, ["roberts", ...args], (argc, argv) => {
      const value = this.exports[name](argc, argv);
      this.exports.free(argv);
      return value;
    });
    return { result, messages: this.system.messages.slice(said) };
  }

  /* Reads the files that the arguments name. Returns the exit status that the program would have, and its messages. */
  open(args) {
    const { result: status, messages } = this.call("live_open", args);
    return { status, messages };
  }

  /* One frame; its lines are a copy. Without a frame, the messages say why. */
  draw(args) {
    const { result: at, messages } = this.call("live_draw", args);
    if (!at) return { messages };
    const view = new DataView(this.exports.memory.buffer, at);
    const count = classes.map((_, i) => view.getUint32(4 * i, true));
    const total = count.reduce((sum, some) => sum + some, 0);
    const double = (offset) => view.getFloat64(offset, true);
    const whole = (offset) => view.getUint32(offset, true);
    return {
      messages,
      count,
      window: [0, 8, 16, 24].map((i) => double(AT.window + i)),
      lines: new Float32Array(this.exports.memory.buffer, whole(AT.line), 4 * total).slice(),
      bodies: whole(AT.bodies),
      faces: whole(AT.faces),
      centre: [0, 8, 16].map((i) => double(AT.centre + i)),
      diameter: double(AT.diameter),
    };
  }
}

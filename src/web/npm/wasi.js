/* wasi.js - what the module asks of its system: files in memory, a clock, and the end of the run.
 *
 * It follows WASI's preview 1 as far as the program uses it. All files are in one folder, the root; the names of those
 * that are given may have slashes. Numbers of open files: 0 to 2 are the standard streams, 3 is the root. */

const ERRNO = { badf: 8, exist: 20, inval: 28, isdir: 31, noent: 44, nosys: 52, notdir: 54, spipe: 70 };
const TYPE = { character: 2, folder: 3, regular: 4 };
const OPEN = { create: 1, folder: 2, exclusive: 4, truncate: 8 };
const ROOT = 3;

/* The program has called exit(). */
export class Exit extends Error {
  constructor(code) {
    super(`exit ${code}`);
    this.code = code;
  }
}

/* The program has left a protected call (src/web/wasi/protect.c). */
class Leave extends Error {
  constructor(code) {
    super(`leave ${code}`);
    this.code = code;
  }
}

/* The bytes of a file; those that are written may be fewer than there is room for. */
class Bytes {
  constructor(bytes, inode) {
    this.room = bytes;
    this.size = bytes.length;
    this.inode = inode;
  }

  write(at, from) {
    const end = at + from.length;
    if (end > this.room.length) {
      const more = new Uint8Array(Math.max(end, 2 * this.room.length, 4096));
      more.set(this.room.subarray(0, this.size));
      this.room = more;
    }
    this.room.set(from, at);
    this.size = Math.max(this.size, end);
  }

  get bytes() {
    return this.room.subarray(0, this.size);
  }
}

/* The name of a file without what leads to the root. */
function inRoot(name) {
  return name.replace(/^(\.?\/)+/, "");
}

/* A system for one instance of the module. `files` maps names to bytes (Uint8Array); the program reads them and adds
 * what it writes. `output` and `messages` are what it wrote to its standard streams. */
export class System {
  constructor(files = {}) {
    this.inodes = 1;
    this.file = new Map();
    for (const [name, bytes] of Object.entries(files)) this.add(inRoot(name), bytes);
    this.given = new Set(this.file.keys());
    this.stream = [new Bytes(new Uint8Array(0), 0), new Bytes(new Uint8Array(0), 0), new Bytes(new Uint8Array(0), 0)];
    this.open = new Map([0, 1, 2].map((number) => [number, { of: this.stream[number], at: 0, stream: true }]));
  }

  add(name, bytes) {
    const file = new Bytes(bytes, this.inodes++);
    this.file.set(name, file);
    return file;
  }

  bytes(name) {
    return this.file.get(name)?.bytes;
  }

  /* The files that were not given: those that the program has written. */
  added() {
    const added = [...this.file].filter(([name]) => !this.given.has(name));
    return Object.fromEntries(added.map(([name, file]) => [name, file.bytes]));
  }

  get output() {
    return this.stream[1].bytes;
  }

  /* Without the advice to run the program, which is not at hand here. */
  get messages() {
    return new TextDecoder().decode(this.stream[2].bytes).replace(/^roberts --help lists the options\.\n/gm, "");
  }

  /* Binds the instance whose calls come here. */
  bind(instance) {
    this.exports = instance.exports;
  }

  view() {
    return new DataView(this.exports.memory.buffer);
  }

  text(at, length) {
    return inRoot(new TextDecoder().decode(new Uint8Array(this.exports.memory.buffer, at, length)));
  }

  vectors(at, count) {
    const view = this.view();
    return Array.from(
      { length: count },
      (_, i) =>
        new Uint8Array(
          this.exports.memory.buffer,
          view.getUint32(at + 8 * i, true),
          view.getUint32(at + 8 * i + 4, true),
        ),
    );
  }

  putStat(at, type, inode, size) {
    const view = this.view();
    for (let i = 0; i < 64; i += 8) view.setBigUint64(at + i, 0n, true);
    view.setBigUint64(at + 8, BigInt(inode), true);
    view.setUint8(at + 16, type);
    view.setBigUint64(at + 24, 1n, true);
    view.setBigUint64(at + 32, BigInt(size), true);
    return 0;
  }

  openFile(name, flags, result) {
    let file = this.file.get(name);
    if (name === "" || name === ".") return flags & OPEN.create ? ERRNO.isdir : ERRNO.inval;
    if (flags & OPEN.folder) return file ? ERRNO.notdir : ERRNO.noent;
    if (!file && (!(flags & OPEN.create) || name.includes("/"))) return ERRNO.noent;
    if (file && flags & OPEN.exclusive) return ERRNO.exist;
    if (!file || flags & OPEN.truncate) file = this.add(name, new Uint8Array(0));
    let number = ROOT + 1;
    while (this.open.has(number)) number++;
    this.open.set(number, { of: file, at: 0 });
    this.view().setUint32(result, number, true);
    return 0;
  }

  read(number, vectors, count, done) {
    const one = this.open.get(number);
    if (!one) return ERRNO.badf;
    let sum = 0;
    for (const to of this.vectors(vectors, count)) {
      const some = one.of.bytes.subarray(one.at, one.at + to.length);
      to.set(some);
      one.at += some.length;
      sum += some.length;
    }
    this.view().setUint32(done, sum, true);
    return 0;
  }

  write(number, vectors, count, done) {
    const one = this.open.get(number);
    if (!one) return ERRNO.badf;
    let sum = 0;
    for (const from of this.vectors(vectors, count)) {
      one.of.write(one.at, from);
      one.at += from.length;
      sum += from.length;
    }
    this.view().setUint32(done, sum, true);
    return 0;
  }

  seek(number, offset, whence, result) {
    const one = this.open.get(number);
    if (!one) return ERRNO.badf;
    if (one.stream) return ERRNO.spipe;
    const at = [0, one.at, one.of.size][whence] + Number(offset);
    if (!(at >= 0)) return ERRNO.inval;
    one.at = at;
    this.view().setBigUint64(result, BigInt(at), true);
    return 0;
  }

  positioned(act, number, vectors, count, offset, done) {
    const one = this.open.get(number);
    if (!one) return ERRNO.badf;
    const kept = one.at;
    one.at = Number(offset);
    const reason = act.call(this, number, vectors, count, done);
    one.at = kept;
    return reason;
  }

  /* The functions that the module imports. */
  imports() {
    const table = {
      args_get: () => 0,
      args_sizes_get: (count, size) => this.putTwo(count, 0, size, 0),
      environ_get: () => 0,
      environ_sizes_get: (count, size) => this.putTwo(count, 0, size, 0),
      clock_res_get: (_clock, at) => this.putLong(at, 1000000n),
      clock_time_get: (clock, _precision, at) =>
        this.putLong(at, BigInt(Math.round(1e6 * (clock === 0 ? Date.now() : performance.now())))),
      fd_close: (number) => (this.open.delete(number) ? 0 : ERRNO.badf),
      fd_fdstat_get: (number, at) => this.describe(number, at),
      fd_fdstat_set_flags: () => 0,
      fd_filestat_get: (number, at) => {
        const one = this.open.get(number);
        if (!one) return ERRNO.badf;
        return this.putStat(at, one.stream ? TYPE.character : TYPE.regular, one.of.inode, one.of.size);
      },
      fd_prestat_get: (number, at) => (number === ROOT ? this.putTwo(at, 0, at + 4, 1) : ERRNO.badf),
      fd_prestat_dir_name: (_number, at) => {
        this.view().setUint8(at, 47);
        return 0;
      },
      fd_read: (...call) => this.read(...call),
      fd_write: (...call) => this.write(...call),
      fd_pread: (...call) => this.positioned(this.read, ...call),
      fd_pwrite: (...call) => this.positioned(this.write, ...call),
      fd_seek: (...call) => this.seek(...call),
      path_filestat_get: (_root, _flags, path, length, at) => {
        const name = this.text(path, length),
          file = this.file.get(name);
        if (name === "" || name === ".") return this.putStat(at, TYPE.folder, 0, 0);
        return file ? this.putStat(at, TYPE.regular, file.inode, file.size) : ERRNO.noent;
      },
      path_open: (_root, _follow, path, length, flags, _rights, _inherit, _fdflags, result) =>
        this.openFile(this.text(path, length), flags, result),
      path_readlink: (_root, path, length) => (this.file.has(this.text(path, length)) ? ERRNO.inval : ERRNO.noent),
      path_rename: (_root, path, length, _to, toPath, toLength) => {
        const name = this.text(path, length),
          file = this.file.get(name);
        if (!file) return ERRNO.noent;
        this.file.delete(name);
        this.file.set(this.text(toPath, toLength), file);
        return 0;
      },
      path_unlink_file: (_root, path, length) => (this.file.delete(this.text(path, length)) ? 0 : ERRNO.noent),
      poll_oneoff: () => ERRNO.nosys,
      proc_exit: (code) => {
        throw new Exit(code);
      },
      sched_yield: () => 0,
    };
    const missing = () => ERRNO.nosys;
    return {
      wasi_snapshot_preview1: new Proxy(table, { get: (known, name) => known[name] ?? missing }),
      env: {
        leave: (code) => {
          throw new Leave(code);
        },
        protect: (index, context) => this.protect(index, context),
      },
    };
  }

  /* The stack is where it was before the call, whichever way the call ends. */
  protect(index, context) {
    const { __indirect_function_table: table, __stack_pointer: stack } = this.exports;
    const kept = stack.value;
    try {
      return table.get(index)(context);
    } catch (error) {
      if (!(error instanceof Leave)) throw error;
      stack.value = kept;
      return error.code;
    }
  }

  putTwo(at, value, second, other) {
    const view = this.view();
    view.setUint32(at, value, true);
    view.setUint32(second, other, true);
    return 0;
  }

  putLong(at, value) {
    this.view().setBigUint64(at, value, true);
    return 0;
  }

  describe(number, at) {
    const one = this.open.get(number);
    if (!one && number !== ROOT) return ERRNO.badf;
    const view = this.view();
    for (let i = 0; i < 24; i += 8) view.setBigUint64(at + i, 0n, true);
    view.setUint8(at, !one ? TYPE.folder : one.stream ? TYPE.character : TYPE.regular);
    view.setBigUint64(at + 8, 0xffffffffn, true);
    view.setBigUint64(at + 16, 0xffffffffn, true);
    return 0;
  }
}

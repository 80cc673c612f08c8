/* browser.js - a headless Chromium under test, by the protocol of its developer tools over a pipe; and a file server on
 * the loopback address. */
import { spawn, spawnSync } from "node:child_process";
import { createReadStream, existsSync, readFileSync, statSync } from "node:fs";
import { createServer } from "node:http";
import path from "node:path";

const types = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm" };

/* Serves a folder. Returns its address, and how to end it. */
export async function serve(folder) {
  const server = createServer((request, response) => {
    const name = decodeURIComponent(new URL(request.url, "http://x").pathname);
    const file = path.join(folder, path.normalize(name === "/" ? "/index.html" : name));
    if (!existsSync(file) || !statSync(file).isFile()) return response.writeHead(404).end();
    response.writeHead(200, { "Content-Type": types[path.extname(file)] ?? "application/octet-stream" });
    createReadStream(file).pipe(response);
  });
  await new Promise((resolve) => server.listen(0, "127.0.0.1", resolve));
  return { address: `http://127.0.0.1:${server.address().port}/`, end: () => server.close() };
}

export function findBrowser() {
  return ["chromium", "chromium-browser", "google-chrome"].find((name) => spawnSync(name, ["--version"]).status === 0);
}

export class Browser {
  constructor(program, folder) {
    this.process = spawn(
      program,
      [
        "--headless=new",
        "--no-sandbox",
        "--disable-gpu",
        "--no-first-run",
        "--disable-extensions",
        "--disable-background-networking",
        "--disable-component-update",
        "--disable-dev-shm-usage",
        `--user-data-dir=${folder}`,
        "--remote-debugging-pipe",
        "--window-size=1280,900",
        "about:blank",
      ],
      { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] },
    );
    this.waiting = new Map();
    this.listeners = [];
    this.next = 1;
    let kept = "";
    this.process.stdio[4].setEncoding("utf8").on("data", (text) => {
      const parts = (kept + text).split("\0");
      kept = parts.pop();
      for (const part of parts) this.take(JSON.parse(part));
    });
  }

  take(message) {
    if (!message.id) return this.listeners.forEach((listen) => listen(message));
    const { resolve, reject } = this.waiting.get(message.id);
    this.waiting.delete(message.id);
    if (message.error) reject(new Error(message.error.message));
    else resolve(message.result);
  }

  send(method, params = {}) {
    const id = this.next++;
    this.process.stdio[3].write(`${JSON.stringify({ id, method, params, sessionId: this.session })}\0`);
    return new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
  }

  async open(address) {
    const { targetId } = await this.send("Target.createTarget", { url: "about:blank" });
    this.session = (await this.send("Target.attachToTarget", { targetId, flatten: true })).sessionId;
    await this.send("Page.enable");
    await this.send("Runtime.enable");
    await this.send("Page.navigate", { url: address });
  }

  async evaluate(expression) {
    const { result, exceptionDetails } = await this.send("Runtime.evaluate", {
      expression,
      returnByValue: true,
      awaitPromise: true,
    });
    if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
    return result.value;
  }

  /* Waits until the expression is true. */
  async until(expression, seconds = 60) {
    const end = Date.now() + 1000 * seconds;
    for (;;) {
      if (await this.evaluate(expression).catch(() => false)) return;
      if (Date.now() > end) throw new Error(`in vain: ${expression}`);
      await new Promise((resolve) => setTimeout(resolve, 30));
    }
  }

  /* The middle of an element. */
  place(selector) {
    return this.evaluate(`(() => { const e = document.querySelector(${JSON.stringify(selector)});
      e.scrollIntoView({ block: "center" });
      const b = e.getBoundingClientRect(); return { x: b.x + b.width / 2, y: b.y + b.height / 2 }; })()`);
  }

  mouse(type, at, buttons = 0) {
    return this.send("Input.dispatchMouseEvent", { type, ...at, button: "left", buttons, clickCount: 1 });
  }

  async click(selector) {
    const at = await this.place(selector);
    await this.mouse("mousePressed", at, 1);
    await this.mouse("mouseReleased", at);
  }

  /* Presses the mouse on an element, moves it in some steps, and lets it go. */
  async drag(selector, dx, dy, steps = 8) {
    const at = await this.place(selector);
    await this.mouse("mousePressed", at, 1);
    for (let i = 1; i <= steps; i++)
      await this.mouse("mouseMoved", { x: at.x + (dx * i) / steps, y: at.y + (dy * i) / steps }, 1);
    await this.mouse("mouseReleased", { x: at.x + dx, y: at.y + dy });
  }

  /* Puts fingers on an element, at places relative to its middle, moves them in some steps, and lifts them. */
  async touch(selector, from, to, steps = 8) {
    const at = await this.place(selector);
    const points = (t) =>
      from.map(([x, y], id) => ({ id, x: at.x + x + t * (to[id][0] - x), y: at.y + y + t * (to[id][1] - y) }));
    const send = (type, touchPoints) => this.send("Input.dispatchTouchEvent", { type, touchPoints });
    await send("touchStart", points(0));
    for (let i = 1; i <= steps; i++) await send("touchMove", points(i / steps));
    await send("touchEnd", []);
  }

  async key(key, modifiers = 0) {
    const more = { Tab: { windowsVirtualKeyCode: 9 }, Enter: { windowsVirtualKeyCode: 13, text: "\r" } }[key];
    await this.send("Input.dispatchKeyEvent", { type: "keyDown", key, code: key, modifiers, ...more });
    await this.send("Input.dispatchKeyEvent", { type: "keyUp", key, code: key, modifiers });
  }

  /* Drops files of this machine on an element. A browser ignores a drop if the page has not yet answered what may be
   * dropped there, as on a busy machine. Then they are dropped again. */
  async drop(selector, ...files) {
    const at = await this.place(selector),
      data = { items: [], files, dragOperationsMask: 1 };
    const before = await this.evaluate(`window.drops ??= (addEventListener("drop", () => window.drops++, true), 0)`);
    for (let tries = 0; ; tries++) {
      for (const type of ["dragEnter", "dragOver", "drop"])
        await this.send("Input.dispatchDragEvent", { type, ...at, data });
      try {
        return await this.until(`window.drops > ${before}`, 5);
      } catch (error) {
        if (tries === 5) throw error;
      }
    }
  }

  /* The processes of the browser: type, id, and seconds of the processor (cpuTime). Those of pages are renderers. */
  async processes() {
    const { session } = this;
    this.session = undefined; // the browser knows, and no page
    const asked = this.send("SystemInfo.getProcessInfo");
    this.session = session;
    return (await asked).processInfo;
  }

  /* The most memory that a process of pages has, in bytes. */
  async memory() {
    const pages = (await this.processes()).filter((one) => one.type === "renderer");
    return Math.max(
      ...pages.map(({ id }) => 1024 * Number(/VmRSS:\s*(\d+)/.exec(readFileSync(`/proc/${id}/status`, "utf8"))[1])),
    );
  }

  async picture() {
    return Buffer.from((await this.send("Page.captureScreenshot")).data, "base64");
  }

  async end() {
    const gone = new Promise((resolve) => this.process.on("exit", resolve));
    this.session = undefined;
    await this.send("Browser.close").catch(() => {});
    const timer = setTimeout(() => this.process.kill("SIGKILL"), 5000);
    await gone;
    clearTimeout(timer);
  }
}

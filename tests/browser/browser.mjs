// A headless Chromium, driven by its DevTools protocol over a pipe: no package of npm is needed.

import { spawn } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";

/// Starts Chromium; open(url) gives a page.
export async function startBrowser(program) {
  const profile = mkdtempSync(join(tmpdir(), "browser-"));
  const child = spawn(program, ["--headless=new", "--no-sandbox", "--remote-debugging-pipe", `--user-data-dir=${profile}`, "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "--disable-dev-shm-usage", "--no-first-run", "--disable-extensions",
    "--disable-background-networking", "--disable-component-update", "--hide-scrollbars", "about:blank"], { stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"] });
  const [, , , to, from] = child.stdio, waiting = new Map(), listeners = [];
  let next = 1, rest = "";
  from.setEncoding("utf8");
  from.on("data", (text) => {
    const parts = (rest + text).split("\0");
    rest = parts.pop();
    for (const part of parts) {
      const message = JSON.parse(part);
      if (message.id) {
        const { resolve, reject } = waiting.get(message.id);
        waiting.delete(message.id);
        if (message.error) reject(new Error(message.error.message)); else resolve(message.result);
      } else for (const l of listeners) l(message);
    }
  });
  child.on("exit", () => { for (const { reject } of waiting.values()) reject(new Error("the browser ended")); });
  const send = (method, params = {}, sessionId) => new Promise((resolve, reject) => {
    const id = next++;
    waiting.set(id, { resolve, reject });
    to.write(JSON.stringify({ id, method, params, sessionId }) + "\0");
  });

  return {
    /// before: a script that runs before those of the page.
    async open(url, width = 640, height = 480, before = "") {
      const { targetId } = await send("Target.createTarget", { url: "about:blank" });
      const { sessionId } = await send("Target.attachToTarget", { targetId, flatten: true });
      const messages = [], call = (method, params) => send(method, params, sessionId);
      let loaded;
      const isLoaded = new Promise((resolve) => { loaded = resolve; });
      listeners.push((m) => {
        if (m.sessionId !== sessionId) return;
        if (m.method === "Page.loadEventFired") loaded();
        if (m.method === "Runtime.exceptionThrown") messages.push(m.params.exceptionDetails.exception?.description ?? m.params.exceptionDetails.text);
        if (m.method === "Runtime.consoleAPICalled") messages.push(m.params.args.map((a) => a.value ?? a.description).join(" "));
        if (m.method === "Log.entryAdded") messages.push(m.params.entry.text);
        if (m.method === "Network.requestWillBeSent" && !/^(file|data|blob):/.test(m.params.request.url)) messages.push(`a request: ${m.params.request.url}`);
      });
      for (const domain of ["Page", "Runtime", "Log", "Network"]) await call(`${domain}.enable`);
      await call("Emulation.setDeviceMetricsOverride", { width, height, deviceScaleFactor: 1, mobile: width < 500 });
      if (before) await call("Page.addScriptToEvaluateOnNewDocument", { source: before });
      await call("Page.navigate", { url });
      await isLoaded;
      const page = {
        messages,
        async run(expression) {
          const { result, exceptionDetails } = await call("Runtime.evaluate", { expression, returnByValue: true, awaitPromise: true });
          if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
          return result.value;
        },
        async picture() { return Buffer.from((await call("Page.captureScreenshot", { format: "png" })).data, "base64"); },
        async mouse(type, x, y, more = {}) { await call("Input.dispatchMouseEvent", { type, x, y, button: "left", clickCount: 1, ...more }); },
        async click(x, y, more = {}) { await page.mouse("mousePressed", x, y, more); await page.mouse("mouseReleased", x, y, more); },
        /// Fingers at [x, y] each; none: they leave.
        async touch(type, ...fingers) {
          await call("Input.dispatchTouchEvent", { type, touchPoints: fingers.map(([x, y], id) => ({ x, y, id })) });
        },
        /// Two taps a tenth of a second after each other.
        async doubleTap(x, y) {
          const now = Date.now() / 1000, at = (type, after, touchPoints) => call("Input.dispatchTouchEvent", { type, touchPoints, timestamp: now + after });
          await Promise.all([0, 0.1].flatMap((t) => [at("touchStart", t, [{ x, y }]), at("touchEnd", t + 0.05, [])]));
        },
        async key(key) { await call("Input.dispatchKeyEvent", { type: "keyDown", key, text: key.length === 1 ? key : undefined }); await call("Input.dispatchKeyEvent", { type: "keyUp", key }); },
        async close() { await send("Target.closeTarget", { targetId }); },
      };
      return page;
    },
    async close() {
      const ended = new Promise((resolve) => child.on("exit", resolve));
      await send("Browser.close").catch(() => {});
      await ended;
      rmSync(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
    },
  };
}

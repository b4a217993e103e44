// Prints the seconds in which a browser loads a page, draws it at rest and while the view moves, and cuts it:  node speed.mjs <chromium> <page.html>
// benchmarks/page_bench.cpp runs this. Before a step is measured it is done once.

import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { startBrowser } from "./browser.mjs";

const [, , program, file] = process.argv, browser = await startBrowser(program);
await (await browser.open("about:blank")).close();  // the browser has started
const begin = performance.now(), page = await browser.open(pathToFileURL(resolve(file)).href, 1280, 800);
// Reading a pixel waits for the picture.
const draw = `(() => { concino.drawScene(); concino.gl.readPixels(0, 0, 1, 1, concino.gl.RGBA, concino.gl.UNSIGNED_BYTE, new Uint8Array(4)); })()`;
await page.run(draw);
const print = (step, seconds) => console.log(`${step} ${seconds.toFixed(4)}`);
print("load", (performance.now() - begin) / 1000);

/// The median time of a picture while the view turns.
const frame = (level) => page.run(`(() => {
  concino.motion.level = ${level};
  const times = [], begin = performance.now();
  while (times.length < 41 && (times.length < 4 || performance.now() - begin < 10000)) {
    const start = performance.now();
    concino.rotate(4, 1);
    ${draw};
    times.push((performance.now() - start) / 1000);
  }
  concino.motion.level = 0;
  return times.slice(1).sort((a, b) => a - b)[Math.floor((times.length - 1) / 2)];
})()`);
print("frame", await frame(0));
print("moving", await frame(2));
print("cut", await page.run(`(() => { const begin = performance.now(); concino.slicing.exact = true; concino.slicing.planes[0].on = true;
  concino.changed("polygons"); return (performance.now() - begin) / 1000; })()`));
for (const m of page.messages) console.error(m);
await page.close();
await browser.close();

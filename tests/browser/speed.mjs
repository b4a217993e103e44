// How long large pages take to load, to draw and to cut, on the graphics processor of this machine or in software:
//   browser_pages FOLDER large && node speed.mjs <chromium> FOLDER

import { statSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { startBrowser } from "./browser.mjs";

const [, , program, folder] = process.argv, browser = await startBrowser(program);
for (const name of ["triangles_100000", "triangles_1000000", "polyhedra_100000"]) {
  const file = join(folder, `${name}.html`), begin = performance.now(), page = await browser.open(pathToFileURL(resolve(file)).href, 1280, 800);
  await page.run("concino.drawScene(); concino.gl.finish()");
  const load = (performance.now() - begin) / 1000;
  const frames = (coarse) => page.run(`(() => {
    concino.motion.coarse = ${coarse};
    const one = new Uint8Array(4), begin = performance.now();
    let n = 0;
    for (; n < 40 && performance.now() - begin < 5000; ++n) {
      concino.press("+"); concino.press("-"); concino.drawScene();
      concino.gl.readPixels(0, 0, 1, 1, concino.gl.RGBA, concino.gl.UNSIGNED_BYTE, one);  // waits for the picture
    }
    concino.motion.coarse = false;
    return n / (performance.now() - begin) * 1000;
  })()`);
  const rest = await frames(false), moving = await frames(true);
  const cut = await page.run(`(() => { const begin = performance.now(); concino.slicing.exact = true; concino.slicing.planes[0].on = true;
    concino.changed("polygons"); return (performance.now() - begin) / 1000; })()`);
  console.log(`${name}: ${(statSync(file).size / 1e6).toFixed(1)} MB, loaded in ${load.toFixed(2)} s, ${rest.toFixed(1)} pictures a second, ${moving.toFixed(1)} while it moves, cut in ${cut.toFixed(2)} s`);
  for (const m of page.messages) console.log(m);
  await page.close();
}
await browser.close();

// What the programs share that open pages in headless Chromium and check what they show:  node program.mjs <chromium> <folder>

import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { startBrowser } from "./browser.mjs";

const [, , program, folderOfPages] = process.argv, browser = await startBrowser(program);
export const folder = folderOfPages;
let passed = 0, failed = 0;

export async function check(name, body) {
  try {
    await body();
    ++passed;
  } catch (e) {
    ++failed;
    console.log(`${name}: ${e.message}`);
  }
}

/// more: { hash, before }
export const open = (name, width, height, more = {}) =>
  browser.open(pathToFileURL(resolve(folder, `${name}.html`)).href + (more.hash ?? ""), width, height, more.before);

/// Which pixels of the drawing are not background: rows of 0 and 1, as pages.cpp writes them.
export const silhouette = `(() => {
  concino.drawScene();
  const gl = concino.gl, w = gl.drawingBufferWidth, h = gl.drawingBufferHeight, rgba = new Uint8Array(4 * w * h), rows = [];
  gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
  for (let y = h - 1; y >= 0; --y) {
    let row = "";
    for (let x = 0; x < w; ++x) row += rgba[4 * (y * w + x)] + rgba[4 * (y * w + x) + 1] + rgba[4 * (y * w + x) + 2] < 765 ? "1" : "0";
    rows.push(row);
  }
  return rows.join("\\n");
})()`;

/// Sets an input as a user does.
export const set = (label, value) => `(() => {
  const e = document.querySelector('[aria-label="${label}"]');
  if (e.type === "checkbox") e.checked = ${JSON.stringify(value)}; else e.value = ${JSON.stringify(String(value))};
  for (const type of ["input", "change"]) e.dispatchEvent(new Event(type));
})()`;

/// The pixels of the drawing, row by row from below, four bytes each, in light colours.
export const pixels = `(() => {
  concino.setTheme(false);
  concino.drawScene();
  const gl = concino.gl, rgba = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
  gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, rgba);
  return [...rgba];
})()`;

/// Reports, and ends the program.
export async function finish() {
  await browser.close();
  console.log(`${passed} passed, ${failed} failed`);
  process.exit(failed ? 1 : 0);
}

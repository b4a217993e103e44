// Opens the pages of pages.cpp in headless Chromium and checks what they show:  node pages.mjs <chromium> <folder>

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { startBrowser } from "./browser.mjs";

const [, , program, folder] = process.argv, browser = await startBrowser(program);
const expected = JSON.parse(readFileSync(join(folder, "expected.json"), "utf8")).filter(Boolean);
let passed = 0, failed = 0;

async function check(name, body) {
  try {
    await body();
    ++passed;
  } catch (e) {
    ++failed;
    console.log(`${name}: ${e.message}`);
  }
}

const open = (name, width, height) => browser.open(pathToFileURL(resolve(folder, `${name}.html`)).href, width, height);

/// Which pixels of the drawing are not background: rows of 0 and 1, as pages.cpp writes them.
const silhouette = `(() => {
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

/// The pixels of a that are farther than two pixels from those of b.
function farther(a, b) {
  let count = 0;
  for (let y = 0; y < a.length; ++y)
    for (let x = 0; x < a[y].length; ++x) {
      if (a[y][x] === "0" || b[y][x] === "1") continue;
      let near = false;
      for (let j = -2; j <= 2; ++j) for (let i = -2; i <= 2; ++i) near ||= b[y + j]?.[x + i] === "1";
      count += near ? 0 : 1;
    }
  return count;
}

/// Sets an input as a user does.
const set = (label, value) => `(() => {
  const e = document.querySelector('[aria-label="${label}"]');
  if (e.type === "checkbox") e.checked = ${JSON.stringify(value)}; else e.value = ${JSON.stringify(String(value))};
  for (const type of ["input", "change"]) e.dispatchEvent(new Event(type));
})()`;

for (const e of expected) {
  const page = await open(e.page);
  const thing = "concino.things()[0]";
  await page.run(`document.getElementById("panel").hidden || concino.press("c")`);

  await check(`${e.page}: the silhouette is that of save_png up to two pixels`, async () => {
    const drawn = (await page.run(silhouette)).split("\n"), traced = readFileSync(join(folder, `${e.page}.txt`), "utf8").trim().split("\n");
    assert.equal(drawn.length, traced.length);
    assert.equal(farther(drawn, traced) + farther(traced, drawn), 0);
    assert.ok(drawn.join("").includes("1"));
  });

  await check(`${e.page}: a pick names the element at a known pixel`, async () => {
    const picked = await page.run(`(() => { const p = concino.pickAt(${e.x}, ${e.y}, "poly"); return { index: p.index, face: p.face, rows: concino.describe(p) }; })()`);
    assert.equal(picked.index, e.poly);
    if (e.volume) assert.equal(picked.face, e.element);
    const rows = Object.fromEntries(picked.rows);
    assert.equal(rows.element, `poly ${e.poly}`);
    assert.equal(rows.label, String(e.label));
    assert.equal(rows.part, `part ${e.poly}`);
    await page.click(e.x, e.y);
    assert.ok((await page.run(`document.getElementById("picked").textContent`)).includes(`label`) ||
      (await page.run(`document.getElementById("picked").textContent`)).includes("height"));
  });

  await check(`${e.page}: whole polys are those of below and peeled`, async () => {
    await page.run(set("place of the cut along x", 0.5));
    assert.equal(await page.run(`${thing}.numShown`), e.below);
    await page.run(`concino.slicing.planes[0].on = false; concino.changed("polygons")`);
    await page.run(set(`layers peeled off ${e.page.replace("_orthographic", "")}`, 1));
    assert.equal(await page.run(`${thing}.numShown`), e.peeled);
    await page.run(set(`layers peeled off ${e.page.replace("_orthographic", "")}`, 0));
    assert.equal(await page.run(`${thing}.numShown`), e.polys);
  });

  await check(`${e.page}: an exact cut has the area of slice`, async () => {
    await page.run(set("kind of cut", "exact"));
    await page.run(set("place of the cut along z", 0.3));
    const areas = await page.run(`${thing}.cutAreas`);
    if (e.volume) assert.ok(Math.abs(areas[0] - e.area) <= 1e-5 * e.area, `${areas[0]} instead of ${e.area}`);
    const shown = await page.run(silhouette);
    assert.ok(shown.includes("1"));
    await page.run(`concino.slicing.planes[2].on = false; concino.slicing.exact = false; concino.changed("polygons")`);
  });

  await check(`${e.page}: keys change the view`, async () => {
    const parallel = await page.run("concino.camera.parallel");
    await page.key("p");
    assert.equal(await page.run("concino.camera.parallel"), !parallel);
    await page.key("1");
    assert.ok((await page.run("concino.camera.back[0]")) > 0.999);
    await page.key("ArrowLeft");
    assert.ok((await page.run("concino.camera.back[0]")) < 0.999);
    const before = await page.run("concino.camera.distance");
    await page.key("+");
    assert.ok((await page.run("concino.camera.distance")) < before);
    await page.key("r");
    assert.equal(await page.run("concino.camera.parallel"), parallel);
  });

  await check(`${e.page}: the pointer rotates and the wheel zooms`, async () => {
    const before = await page.run("[concino.camera.back, concino.camera.distance]");
    await page.mouse("mousePressed", 320, 240, { buttons: 1 });
    await page.mouse("mouseMoved", 360, 260, { buttons: 1 });
    await page.mouse("mouseReleased", 360, 260);
    await page.mouse("mouseWheel", 320, 240, { button: "none", deltaX: 0, deltaY: -240 });
    const after = await page.run("new Promise((done) => setTimeout(() => done([concino.camera.back, concino.camera.distance]), 100))");
    assert.notDeepEqual(after[0], before[0]);
    assert.ok(after[1] < before[1]);
  });

  await check(`${e.page}: colours, maps, arrows and elements by index`, async () => {
    const name = e.page.replace("_orthographic", "");
    for (const chosen of ["0", "1", "2", "3", "color"]) await page.run(set(`colours of ${name}`, chosen));
    await page.run(set(`colours of ${name}`, "1"));
    for (const map of ["0", "3", "5"]) await page.run(set(`colour map of ${name}`, map));
    await page.run(set("white bands", 6));
    await page.run(set(`arrows of ${name}`, "2"));
    assert.ok(await page.run(`${thing}.parts.length === 2 && concino.goTo(${thing}, "edge", 3) && !concino.goTo(${thing}, "poly", ${e.polys})`));
    await page.run(silhouette);
  });

  await check(`${e.page}: nothing on the console, no request`, async () => assert.deepEqual(page.messages, []));
  await page.close();
}

for (const name of ["strings", "empty", "large", "small", "one", "no_values"]) {
  const page = await open(name, 1000, 700);
  await check(`${name}: is shown`, async () => {
    const shown = name === "no_values" ? true : (await page.run(silhouette)).includes("1");
    assert.equal(shown, name !== "empty");
    assert.deepEqual(page.messages, []);
  });
  if (name === "strings") await check("texts run nothing and are shown as they are", async () => {
    assert.equal(await page.run("window.broken"), undefined);
    assert.equal(await page.run("document.images.length"), 0);
    const evil = "</script><script>window.broken = 1</script><img src=x onerror='window.broken = 2'>\"'\\\u0001 \u202eabc";
    assert.equal(await page.run(`document.getElementById("title").textContent`), evil);
    assert.equal(await page.run(`concino.things()[0].name`), evil);
    await page.run(`concino.goTo(concino.things()[0], "vert", 0)`);
    const rows = await page.run(`concino.describe({ thing: concino.things()[0], kind: "vert", index: 0 })`);
    assert.deepEqual(rows.at(-1), [evil, evil]);
  });
  if (name === "no_values") await check("values that are no numbers have their colour and say so", async () => {
    const rows = await page.run(`[0, 1, 2, 3, 4, 5, 6, 7, 8, 9].map((i) => i * 5).map((i) => concino.describe({ thing: concino.things()[0], kind: "vert", index: i }).find(([name]) => name === "field")[1])`);
    assert.ok(rows.includes("not a number") && rows.includes("1"), rows.join());
    const greys = await page.run(`(() => { concino.setTheme(false); concino.drawScene(); const gl = concino.gl, w = gl.drawingBufferWidth, h = gl.drawingBufferHeight, rgba = new Uint8Array(4 * w * h);
      gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, rgba); let grey = 0, other = 0;
      for (let i = 0; i < rgba.length; i += 4) { const s = rgba[i] + rgba[i + 1] + rgba[i + 2]; if (s === 765) continue; if (rgba[i] === rgba[i + 1] && rgba[i] === rgba[i + 2]) ++grey; else ++other; }
      return [grey, other]; })()`);
    assert.ok(greys[0] > 1000 && greys[1] > 1000, greys.join());
  });
  if (name === "large" || name === "small") await check(`${name}: coordinates`, async () => {
    const x = await page.run(`(() => { const t = concino.things()[0]; return Math.max(...t.mesh.points); })()`);
    assert.ok(Math.abs(x / (name === "large" ? 1e30 : 1e-30) - 1) < 1e-6, String(x));
  });
  await page.close();
}

await browser.close();
console.log(`${passed} passed, ${failed} failed`);
process.exit(failed ? 1 : 0);

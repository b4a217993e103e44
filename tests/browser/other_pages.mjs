// Opens the pages of odd scenes, of textures and of other libraries' meshes, and checks what they show:  node other_pages.mjs <chromium> <folder>

import assert from "node:assert/strict";
import { existsSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { check, finish, folder, open, pixels, silhouette } from "./checks.mjs";

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
    const rgba = await page.run(pixels), greys = [0, 0];
    for (let i = 0; i < rgba.length; i += 4)
      if (rgba[i] + rgba[i + 1] + rgba[i + 2] < 765) ++greys[rgba[i] === rgba[i + 1] && rgba[i] === rgba[i + 2] ? 0 : 1];
    assert.ok(greys[0] > 1000 && greys[1] > 1000, greys.join());
  });
  if (name === "large" || name === "small") await check(`${name}: coordinates`, async () => {
    const x = await page.run(`(() => { const t = concino.things()[0]; return Math.max(...t.mesh.points); })()`);
    assert.ok(Math.abs(x / (name === "large" ? 1e30 : 1e-30) - 1) < 1e-6, String(x));
  });
  await page.close();
}

{
  const page = await open("one", 640, 480, { before: "HTMLCanvasElement.prototype.getContext = () => null" });
  await check("without WebGL 2, the page says so", async () => {
    assert.ok((await page.run(`document.getElementById("message").textContent`)).includes("WebGL 2"));
    for (const key of ["1", "p", "r", "ArrowLeft", "s", "d"]) await page.key(key);
    await page.click(320, 240);
    await page.run("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))");
    assert.deepEqual(page.messages, []);
  });
  await page.close();
}

// Textures: of red, green and blue the same is strongest, but at pixels beside others.
for (const name of ["squares", "lines", "picture", "clamped", "volume"]) {
  const page = await open(`texture_${name}`), traced = readFileSync(join(folder, `texture_${name}.txt`), "utf8").trim().split("\n");
  await check(`a texture of ${name} is that of save_png`, async () => {
    const rgba = await page.run(pixels), linear = (b) => (b / 255) ** 2.2;
    const drawn = (x, y) => {
      const [r, g, b] = [0, 1, 2].map((k) => linear(rgba[4 * ((479 - y) * 640 + x) + k]));
      return r > 2 * g && r > 2 * b ? "r" : g > 2 * r && g > 2 * b ? "g" : b > 2 * r && b > 2 * g ? "b" : ".";
    };
    const count = { r: 0, g: 0, b: 0 };
    let others = 0, all = 0;
    for (let y = 2; y < 478; ++y) for (let x = 2; x < 638; ++x) {
      const c = traced[y][x];
      if (c === "." || ![-2, 2].every((d) => traced[y + d][x] === c && traced[y][x + d] === c)) continue;
      ++all; ++count[c];
      if (drawn(x, y) !== c) ++others;
    }
    const present = { squares: "rg", lines: "rb", picture: "rgb", clamped: "rgb", volume: "rg" }[name];
    assert.ok([...present].every((c) => count[c] > 500), JSON.stringify(count));
    assert.ok(others < 0.002 * all, `${others} of ${all} pixels differ`);
    assert.deepEqual(page.messages, []);
  });
  if (name === "volume") await check("values at corners: picked, and as colours", async () => {
    const told = Object.fromEntries(await page.run(`concino.describe({ thing: concino.things()[0], kind: "poly", index: 1 })`));
    const points = await page.run(`[...concino.things()[0].mesh.points]`), corners = told["uv, by vert"].split("; ").map((text) => text.split(/: |, /).map(Number));
    assert.equal(corners.length, 8);
    for (const [v, x, y] of corners)
      assert.ok(Math.abs(x - points[3 * v] - points[3 * v + 2] - 0.1) < 1e-6 && Math.abs(y - points[3 * v + 1]) < 1e-6, told["uv, by vert"]);
    await page.run(`(() => { const t = concino.things()[0]; t.choose(String(t.fields.findIndex((f) => f.name === "uv"))); t.textured = false; concino.changed("colors", t); })()`);
    assert.ok((await page.run(silhouette)).includes("1"));
  });
  await page.close();
}

// One mesh through four libraries: the pixels are the same, and so is what is said of picked elements. The numbers of edges differ.
if (existsSync(join(folder, "same_native.html"))) {
  const told = `(() => {
    const sorted = (text) => text.split(" ").sort().join(" "), rows = [];
    for (let x = 20; x < 640; x += 24) for (let y = 20; y < 480; y += 24) for (const kind of ["vert", "edge", "poly"]) {
      const p = concino.pickAt(x, y, kind);
      rows.push([x, y, kind, ...(p ? concino.describe(p).filter(([name]) => name !== "edges" && (kind !== "edge" || name !== "element"))
        .map(([name, value]) => name + ": " + (/verts|polys/.test(name) ? sorted(value) : name === "centroid" ? value.split(", ").map((x) => Number(x).toFixed(9)) : value)) : [])].join(", "));
    }
    return rows;
  })()`;
  let first;
  for (const name of ["native", "openmesh", "cgal", "arrays"]) {
    const page = await open(`same_${name}`), here = { told: await page.run(told), pixels: await page.run(pixels), messages: page.messages };
    first ??= here;
    await check(`${name}: the same picture and the same values when picked`, async () => {
      assert.ok(here.told.filter((row) => row.includes("field: ")).length > 200);
      assert.deepEqual(here.told, first.told);
      assert.ok(here.pixels.filter((x, i) => Math.abs(x - first.pixels[i]) > 8).length < 40);
      assert.deepEqual(here.messages, []);
    });
    await page.close();
  }
} else console.log("SKIPPED: pages of OpenMesh and CGAL");

await finish();

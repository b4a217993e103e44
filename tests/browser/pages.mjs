// Opens the pages of the six kinds of mesh that pages.cpp writes, or one of them, and checks what they show:
//   node pages.mjs <chromium> <folder> [page]

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { check, finish, folder, open, set, silhouette } from "./checks.mjs";

const expected = JSON.parse(readFileSync(join(folder, "expected.json"), "utf8")).filter(Boolean);

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

for (const e of expected.filter((x) => !process.argv[4] || x.page === process.argv[4])) {
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

  await check(`${e.page}: polys by label and by value`, async () => {
    const shown = (isShown) => Array.from({ length: e.polys }, (_, i) => i % 7).filter(isShown).length;
    await page.run(set("labels shown", "1 2"));
    assert.equal(await page.run(`${thing}.numShown`), shown((x) => x === 1 || x === 2));
    await page.run(set("labels shown", ""));
    await page.run(set("lowest shown", 4));
    assert.equal(await page.run(`${thing}.numShown`), shown((x) => x >= 4));
    await page.run(`${thing}.filter.on = false; concino.changed("polygons")`);
  });

  await check(`${e.page}: Shift and clicks measure a distance`, async () => {
    const [from, to, length] = await page.run(`(() => { const { mesh } = ${thing}, verts = [...mesh.cornersOf(${e.element})].map((v) => mesh.point(v));
      const mean = [0, 1, 2].map((k) => verts.reduce((sum, v) => sum + v[k], 0) / verts.length), half = mean.map((x, k) => x / 2 + verts[0][k] / 2);
      return [concino.pixelOf(mean), concino.pixelOf(half), Math.hypot(...mean.map((x, k) => x - half[k])) * concino.scene.radius]; })()`);
    for (const [x, y] of [from, to]) await page.click(x, y, { modifiers: 8 });
    const text = await page.run(`document.getElementById("picked").textContent`), distance = Number(/distance([-.0-9e]+)$/.exec(text)?.[1]);
    assert.ok(Math.abs(distance / length - 1) < 0.06, `${text}, not ${length}`);
    await page.key("Escape");
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
    await page.key("v");
    const hash = await page.run("location.hash"), copy = await open(e.page, 640, 480, { hash });
    const backs = [await page.run("concino.camera.back"), await copy.run("concino.camera.back")];
    assert.ok([0, 1, 2].every((k) => Math.abs(backs[0][k] - backs[1][k]) < 1e-6), hash);
    await copy.close();
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

  await check(`${e.page}: fingers rotate, move, zoom and centre`, async () => {
    await page.key("r");
    const state = () => page.run("({ ...concino.camera, half: concino.halfHeight() })");
    const start = await state();
    /// The state when it is as expected, or that after 5 seconds: events come with the pictures, and those of two fingers one by one.
    const stateWhen = async (expected) => {
      for (let i = 0; i < 100; ++i) {
        const now = await state();
        if (expected(now)) return now;
        await new Promise((done) => setTimeout(done, 50));
      }
      return state();
    };
    const differs = (a, b) => JSON.stringify(a) !== JSON.stringify(b), near = (a, b) => Math.abs(a - b) < 1e-6;
    await page.touch("touchStart", [320, 240]);
    await page.touch("touchMove", [360, 260]);
    await page.touch("touchEnd");
    const rotated = await stateWhen((now) => differs(now, start));
    assert.notDeepEqual(rotated.back, start.back);
    assert.deepEqual([rotated.target, rotated.half], [start.target, start.half]);

    await page.key("r");
    await page.touch("touchStart", [280, 240], [360, 240]);
    await page.touch("touchMove", [310, 260], [390, 260]);  // 30 to the right, 20 down
    const step = 2 * start.half / 480, by = (now, axis) => [0, 1, 2].reduce((sum, k) => sum + (now.target[k] - start.target[k]) * start[axis][k], 0) / step;
    const hasMoved = (now) => near(now.half / start.half, 1) && near(by(now, "right"), -30) && near(by(now, "up"), 20);
    const moved = await stateWhen(hasMoved);
    assert.deepEqual(moved.back, start.back);
    assert.ok(hasMoved(moved), `${by(moved, "right")} ${by(moved, "up")} ${moved.half / start.half}`);
    await page.touch("touchMove", [270, 260], [430, 260]);  // twice as far from each other
    const zoomed = await stateWhen((now) => near(now.half / moved.half, 0.5));
    assert.ok(near(zoomed.half / moved.half, 0.5), String(zoomed.half / moved.half));
    await page.touch("touchEnd");

    await page.key("r");
    await page.doubleTap(e.x, e.y);
    const centred = await stateWhen((now) => differs(now.target, start.target)), back = await page.run(`concino.pixelOf(${JSON.stringify(centred.target)})`);
    assert.notDeepEqual(centred.target, start.target);
    assert.ok(Math.hypot(back[0] - 320, back[1] - 240) < 1e-6);
    const picked = await page.run(`concino.pickAt(320, 240, "poly").index`);
    assert.equal(picked, e.poly);
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

  await check(`${e.page}: fewer pixels while the view moves, all when it rests`, async () => {
    const count = async (before = "") => (await page.run(before + silhouette)).split("1").length, all = await count("concino.motion.level = 0;");
    for (const corners of [60000, 0]) {  // all triangles, and fewer
      const few = (await count(`concino.motion.level = 2; concino.motion.manyCorners = ${corners};`)) / 0.16;
      assert.ok(Math.abs(few / all - 1) < 0.06, `${few} instead of ${all}`);
    }
    await page.run(`concino.motion.moving = 2; concino.redrawMoving()`);
    const width = () => page.run("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => done(concino.gl.drawingBufferWidth))))");
    assert.equal(await width(), 256);
    for (let i = 0; i < 100 && (await width()) !== 640; ++i) await new Promise((done) => setTimeout(done, 50));
    assert.equal(await width(), 640);
    assert.ok((await page.run(silhouette)).includes("1"));
  });

  await check(`${e.page}: nothing on the console, no request`, async () => assert.deepEqual(page.messages, []));
  await page.close();
}

await finish();

// Pictures of pages, to look at:  node screenshots.mjs <chromium> <folder> <page.html> [expression]

import { writeFileSync } from "node:fs";
import { basename, join, resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { startBrowser } from "./browser.mjs";

const [, , program, folder, file, expression] = process.argv, browser = await startBrowser(program);
for (const [width, height] of [[1280, 800], [390, 844]])
  for (const theme of ["light", "dark"]) {
    const page = await browser.open(pathToFileURL(resolve(file)).href, width, height);
    await page.run(`concino.setTheme(${theme === "dark"})`);
    if (expression) await page.run(expression);
    await page.run("new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)))");
    writeFileSync(join(folder, `${basename(file, ".html")}_${width}_${theme}.png`), await page.picture());
    for (const m of page.messages) console.log(m);
    await page.close();
  }
await browser.close();

// Validates all .glb files of a folder: node validate.cjs FOLDER_OF_GLTF_VALIDATOR FOLDER. Fails if one has an error or a warning.
const fs = require('fs'), path = require('path');
const [, , validator, folder] = process.argv;
const { validateBytes } = require(path.resolve(validator));

(async () => {
  let failed = 0, files = 0;
  for (const file of fs.readdirSync(folder).filter(f => f.endsWith('.glb'))) {
    const report = await validateBytes(new Uint8Array(fs.readFileSync(path.join(folder, file))), { maxIssues: 20 });
    ++files;
    const { numErrors, numWarnings, numInfos, messages } = report.issues;
    console.log(`${file}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} remarks`);
    for (const m of messages) if (m.severity < 2) console.log(`  ${m.code} at ${m.pointer}: ${m.message}`);
    failed += numErrors > 0 || numWarnings > 0;
  }
  console.log(`${files} files, ${failed} with errors or warnings`);
  process.exit(failed > 0 || files === 0 ? 1 : 0);
})();

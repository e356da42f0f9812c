// Studies tables with the page's module under node: node study.js MODULE_FOLDER FORM TABLE...
// Prints for each table one line of JSON: the row of study.json, or the sentence of a refusal, and the milliseconds.
// node study.js MODULE_FOLDER --request JSON prints the answer to a request (browser/session.h).
const fs = require("fs");
const path = require("path");

const [folder, form, ...tables] = process.argv.slice(2);

async function main() {
  const module = await require(path.resolve(folder, "brdf.js"))({wasmBinary: fs.readFileSync(path.join(folder, "brdf.wasm"))});
  const text = string => {
    const size = module.lengthBytesUTF8(string) + 1, at = module._malloc(size);
    module.stringToUTF8(string, at, size);
    return at;
  };
  const answerTo = request => JSON.parse(module.UTF8ToString(module._brdf_call(text(request))));
  if (form === "--request") return console.log(JSON.stringify(answerTo(tables[0])));
  for (const file of tables) {
    const bytes = fs.readFileSync(file), name = path.basename(file);
    module._brdf_clear();
    module.HEAPU8.set(bytes, module._brdf_put(text(name), bytes.length));
    const begin = process.cpuUsage();
    const answer = answerTo(JSON.stringify({do: "study", table: name, form}));
    const used = process.cpuUsage(begin);
    const milliseconds = Math.round((used.user + used.system) / 1000);
    console.log(JSON.stringify({table: file, error: answer.error, row: answer.row, milliseconds,
                                heap: module.HEAPU8.length}));
  }
}

main().catch(error => {
  console.error(error);
  process.exit(1);
});

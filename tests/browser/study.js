// Studies tables with the page's module under node: node study.js MODULE_FOLDER FORM TABLE...
// Prints for each table one line of JSON: the row of study.json, or the sentence of a refusal, and the milliseconds.
// node study.js MODULE_FOLDER --request JSON prints the answer to a request (browser/session.h).
const fs = require("fs");
const path = require("path");

const [folder, form, ...tables] = process.argv.slice(2);

async function main() {
  let begin, first;  // processor time at the start of a study, and at its first result
  const milliseconds = ({user, system}) => Math.round((user + system) / 1000);
  const module = await require(path.resolve(folder, "brdf.js"))({
    wasmBinary: fs.readFileSync(path.join(folder, "brdf.wasm")),
    onFitted: statement => { first = {statement, milliseconds: milliseconds(process.cpuUsage(begin))}; },
  });
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
    first = undefined;
    begin = process.cpuUsage();
    const answer = answerTo(JSON.stringify({do: "study", table: name, form}));
    console.log(JSON.stringify({table: file, error: answer.error, row: answer.row, command: answer.command, first, heap: module.HEAPU8.length,
                                milliseconds: milliseconds(process.cpuUsage(begin))}));
  }
}

main().catch(error => {
  console.error(error);
  process.exit(1);
});

// The program in a thread of its own. Follows brdf.js (createBrdf) in one text.
// Receives {start: wasm}, with the module as bytes or in base64, and {request, file}; answers {ready}, {progress}, {fitted}, {answer, files}, {stopped}.
let program;

const bytesOf = (wasm) => typeof wasm === "string" ? Uint8Array.from(atob(wasm), (c) => c.charCodeAt(0)) : new Uint8Array(wasm);

const textToProgram = (text) => {
  const room = program.lengthBytesUTF8(text) + 1, place = program._malloc(room);
  if (!place) throw new Error("the memory of the page is exhausted");
  program.stringToUTF8(text, place, room);
  return place;
};

const call = (request) => {
  const place = textToProgram(JSON.stringify(request));
  const answer = JSON.parse(program.UTF8ToString(program._brdf_call(place)));
  program._free(place);
  return answer;
};

const outputs = (names = []) => names.map((name, k) => {
  const begin = program._brdf_file(k);
  return { name, data: program.HEAPU8.slice(begin, begin + program._brdf_size(k)).buffer };
});

// The addresses of the program have 32 bits, and a fit needs several times the size of its table.
const kMostBytes = 1e9;

const tooLarge = (file) => `${file.name}: the file has ${file.size} bytes, more than the memory of the page can hold; use the installed program`;

const put = async (file) => {
  if (file.size > kMostBytes) return tooLarge(file);
  let bytes;
  try {
    bytes = new Uint8Array(await file.arrayBuffer());
  } catch (fault) {
    return file.name + ": the browser cannot read the file (" + fault.message + "); choose a file, not a folder, and choose it again if it has changed";
  }
  const name = textToProgram(file.name), place = program._brdf_put(name, bytes.length);
  program._free(name);
  if (!place && bytes.length) return tooLarge(file);
  program.HEAPU8.set(bytes, place);
  return "";
};

const answerTo = async ({ request, file }) => {
  const fault = file ? await put(file) : "";
  const answer = fault ? { error: fault } : call(request), files = outputs(answer.files);
  program._brdf_clear();
  postMessage({ answer, files }, files.map(({ data }) => data));
};

onmessage = async ({ data }) => {
  try {
    if (data.request) return await answerTo(data);
    program = await createBrdf({
      wasmBinary: bytesOf(data.start),
      onProgress: (text, share) => postMessage({ progress: { text, share } }),
      onFitted: (fitted) => postMessage({ fitted }),
    });
    postMessage({ ready: call({ do: "about" }) });
  } catch (fault) {
    postMessage({ stopped: fault.message ?? String(fault) });
  }
};

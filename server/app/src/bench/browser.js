// @ts-check
// Runs in the page: times decoders on the same models in turns and posts the best times.

/** Milliseconds between two looks at the clock, which take some time themselves. */
const LONG_ENOUGH = 60;

const bytesOf = async (address) => new Uint8Array(await (await fetch(address)).arrayBuffer());

/** Processor time of this page in milliseconds; the time of day where the system does not tell. */
const clock = async () => Number(await (await fetch('/clock')).text()) || performance.now();

/** Waits for a script that makes a global function, and takes that away from it for the next one. */
async function dracoModule(script, options) {
  const element = document.createElement('script');
  element.src = script;
  await new Promise((resolve, reject) => {
    element.onload = resolve;
    element.onerror = () => reject(new Error(`${script} does not come`));
    document.head.append(element);
  });
  return globalThis.DracoDecoderModule(options);
}

/** Decodes into Draco's own mesh. */
function dracoDecode(draco) {
  return ({ file }) => {
    const decoder = new draco.Decoder();
    const mesh = new draco.Mesh();
    if (!decoder.DecodeArrayToMesh(file, file.length, mesh).ok()) throw new Error('Draco does not decode its own file');
    const faces = mesh.num_faces();
    draco.destroy(mesh);
    draco.destroy(decoder);
    return faces;
  };
}

async function jsmDecode(build, kind) {
  const { loadDecoder } = await import(`/build-${build}/decode/load-decoder.js`);
  const decoder = await loadDecoder(kind);
  if (decoder.kind !== kind) throw new Error(`asked for ${kind}, got ${decoder.kind}`);
  return ({ file }) => {
    decoder.open();
    decoder.feed(file);
    if (!decoder.isComplete) throw new Error('the archive is not complete');
    return decoder.header.faces;
  };
}

async function meshoptDecode() {
  const module = '/meshopt/meshopt_decoder.mjs';
  const { MeshoptDecoder } = await import(module);
  await MeshoptDecoder.ready;
  return ({ file, points, vertices, indices }) => {
    const faces = new Uint8Array(4 * indices);
    MeshoptDecoder.decodeVertexBuffer(new Uint8Array(12 * vertices), vertices, 12, file.subarray(0, points));
    MeshoptDecoder.decodeIndexBuffer(faces, indices, 4, file.subarray(points));
    return indices / 3;
  };
}

async function decoderOf({ sort, build, kind }) {
  if (sort === 'jsm') return jsmDecode(build, kind);
  if (sort === 'meshopt') return meshoptDecode();
  if (kind === 'js') return dracoDecode(await dracoModule('/three/draco_decoder.js', {}));
  return dracoDecode(await dracoModule('/draco/draco_decoder_nodejs.js', { wasmBinary: await bytesOf('/draco/draco_decoder.wasm') }));
}

/** Least milliseconds of each decoder; they take turns, so that what else the machine does troubles all alike. */
async function measure(decoders, { index, faces, runs, rows }) {
  const files = await Promise.all(rows.map(async (row, i) => row && { ...row, file: await bytesOf(`/model/${index}/${i}`) }));
  const best = decoders.map(() => Infinity);
  const times = decoders.map(() => 1);
  for (let run = 0; run < runs; run++) {
    for (const [i, decode] of decoders.entries()) {
      if (!files[i]) continue;
      const start = await clock();
      for (let n = 0; n < times[i]; n++) {
        const found = decode(files[i]);
        if (found !== faces) throw new Error(`decoder ${i} gives ${found} faces, not ${faces}`);
      }
      const millis = ((await clock()) - start) / times[i];
      best[i] = Math.min(best[i], millis);
      times[i] = Math.max(1, Math.round(LONG_ENOUGH / best[i]));
    }
  }
  return best.map((millis) => (millis === Infinity ? null : millis));
}

try {
  const { decoders: wanted, models } = await (await fetch('/task.json')).json();
  const decoders = [];
  for (const one of wanted) decoders.push(await decoderOf(one));
  const millis = [];
  for (const model of models) millis.push(await measure(decoders, model));
  await fetch('/result', { method: 'POST', body: JSON.stringify({ millis, browser: navigator.userAgent }) });
} catch (error) {
  await fetch('/result', { method: 'POST', body: JSON.stringify({ error: String(error) }) });
}

export {}; // a module

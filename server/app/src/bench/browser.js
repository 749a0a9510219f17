// @ts-check
// Runs in the page: times decoders on the same models in turns and posts the best times.

import { loadDecoder } from '/modules/decode/load-decoder.js';

const bytesOf = async (address) => new Uint8Array(await (await fetch(address)).arrayBuffer());

async function dracoDecode() {
  const draco = await globalThis.DracoDecoderModule({ wasmBinary: await bytesOf('/draco/draco_decoder.wasm') });
  return (bytes) => {
    const decoder = new draco.Decoder();
    const mesh = new draco.Mesh();
    if (!decoder.DecodeArrayToMesh(bytes, bytes.length, mesh).ok()) throw new Error('Draco does not decode its own file');
    const faces = mesh.num_faces();
    draco.destroy(mesh);
    draco.destroy(decoder);
    return faces;
  };
}

async function jsmDecode(kind) {
  const decoder = await loadDecoder(kind);
  if (decoder.kind !== kind) throw new Error(`asked for ${kind}, got ${decoder.kind}`);
  return (bytes) => {
    decoder.open();
    decoder.feed(bytes);
    if (!decoder.isComplete) throw new Error('the archive is not complete');
    return decoder.header.faces;
  };
}

/** Least milliseconds of each decoder; they take turns, so that what else the machine does troubles all alike. */
async function measure(decoders, { index, faces, runs }) {
  const files = { jsm: await bytesOf(`/model/${index}.jsm`), drc: await bytesOf(`/model/${index}.drc`) };
  const best = decoders.map(() => Infinity);
  for (let run = 0; run < runs; run++) {
    for (const [i, { decode, type }] of decoders.entries()) {
      const start = performance.now();
      const found = decode(files[type]);
      best[i] = Math.min(best[i], performance.now() - start);
      if (found !== faces) throw new Error(`${decoders[i].name} gives ${found} faces, not ${faces}`);
      await new Promise((resolve) => setTimeout(resolve));
    }
  }
  return best;
}

try {
  const decoders = [
    { name: 'jSM as WebAssembly', type: 'jsm', decode: await jsmDecode('wasm') },
    { name: 'jSM as JavaScript', type: 'jsm', decode: await jsmDecode('js') },
    { name: 'Draco (WebAssembly)', type: 'drc', decode: await dracoDecode() },
  ];
  const models = [];
  for (const model of await (await fetch('/models.json')).json()) models.push(await measure(decoders, model));
  await fetch('/result', { method: 'POST', body: JSON.stringify({ names: decoders.map((d) => d.name), models, browser: navigator.userAgent }) });
} catch (error) {
  await fetch('/result', { method: 'POST', body: JSON.stringify({ error: String(error) }) });
}

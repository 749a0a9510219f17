// @ts-check
// Whether several workers decode several models sooner than one: node workers.mjs [--models=N] ARCHIVE.jsm decodes an
// archive N times in 1, 2, ... workers of Node, in 25 steps, without a page or a link. Processor time tells what waiting
// for other work leaves out.

import fs from 'node:fs';
import os from 'node:os';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { isMainThread, parentPort, Worker, workerData } from 'node:worker_threads';

const STEPS = 25;
const ROUNDS = 3;
const modules = path.resolve(path.dirname(fileURLToPath(import.meta.url)), '../../../../client/web/target/test-classes/META-INF/resources/jsm/modules');

async function decode() {
  const { file, models } = workerData;
  const { loadDecoder } = await import(path.join(modules, 'decode/load-decoder.js'));
  const bytes = fs.readFileSync(file);
  parentPort?.once('message', async () => {
    for (let i = 0; i < models; i++) {
      const decoder = await loadDecoder('js');
      for (let step = 0; step < STEPS; step++) {
        decoder.feed(bytes.subarray(Math.floor((step * bytes.length) / STEPS), Math.floor(((step + 1) * bytes.length) / STEPS)));
        if (decoder.batches > 0) decoder.refine();
      }
      if (!decoder.isComplete) throw new Error('the archive is not complete');
    }
    parentPort?.postMessage('done');
  });
  parentPort?.postMessage('ready');
}

/**
 * Wall and processor time, in seconds, until all are decoded.
 *
 * @param {string} file
 * @param {number} models
 * @param {number} count of workers
 */
async function measure(file, models, count) {
  const workers = Array.from({ length: count }, (_, i) => new Worker(fileURLToPath(import.meta.url), { workerData: { file, models: Math.floor((models + i) / count) } }));
  const all = () => Promise.all(workers.map((worker) => new Promise((resolve, reject) => worker.once('message', resolve).once('error', reject))));
  await all();
  const [start, before] = [performance.now(), process.cpuUsage()];
  workers.forEach((worker) => worker.postMessage('go'));
  await all();
  const { user, system } = process.cpuUsage(before);
  const millis = performance.now() - start;
  await Promise.all(workers.map((worker) => worker.terminate()));
  return [millis / 1000, (user + system) / 1e6];
}

if (isMainThread) {
  const args = process.argv.slice(2);
  const file = args.find((arg) => !arg.startsWith('--'));
  const models = Number(args.find((arg) => arg.startsWith('--models='))?.slice('--models='.length) ?? 4);
  if (file === undefined || !(models > 0)) {
    console.error('usage: node workers.mjs [--models=N] ARCHIVE.jsm');
    process.exit(2);
  }
  console.log(`${os.cpus().length} × ${os.cpus()[0].model.trim()}, load ${os.loadavg()[0].toFixed(1)}\n`);
  console.log('| workers | s until all are decoded | processor time, s |\n|---:|---:|---:|');
  for (let count = 1; count <= Math.min(models, os.availableParallelism()); count++) {
    const rounds = [];
    for (let round = 0; round < ROUNDS; round++) rounds.push(await measure(file, models, count));
    const [wall, cpu] = rounds.sort((a, b) => a[0] - b[0])[0];
    console.log(`| ${count} | ${wall.toFixed(1)} | ${cpu.toFixed(1)} |`);
  }
} else {
  await decode();
}

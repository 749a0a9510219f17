import 'fake-indexeddb/auto';
import assert from 'node:assert/strict';
import test from 'node:test';
import { ArchiveStream } from '../../main/js/decode/archive-stream.js';
import { Succession } from '../../main/js/decode/succession.js';
import { FakeDecoder } from './support/fake-decoder.js';
import { bytesUpTo, partOf, serve, standOn } from './support/web.js';

standOn('http://host/page');

/** @param {unknown} header */
function waiting(header) {
  /** @type {any} */
  const decoder = { header, asked: 0, prepare: () => decoder.asked++ };
  return { decoder, succession: new Succession(decoder) };
}

const PLAIN = { faces: 1000, slots: [{ textures: {} }] };

test('brings the whole decoder at once where that costs no time', () => {
  const { decoder, succession } = waiting(null);
  succession.begin(249_000);
  assert.equal(decoder.asked, 0);
  succession.hear(250_000);
  assert.equal(decoder.asked, 1);
  succession.begin(0);
  assert.equal(decoder.asked, 2);
});

test('brings the whole decoder for large models and for images, however slow the link is', () => {
  const large = { ...PLAIN, faces: 150_001 };
  const textured = { faces: 2, slots: [{ textures: { COLOUR: {} } }] };
  const gltf = { faces: null, slots: [{ gltf: '{}' }] };
  for (const [header, asked] of [[PLAIN, 0], [large, 1], [textured, 1], [gltf, 1]]) {
    const { decoder, succession } = waiting(header);
    succession.hear(8000);
    assert.equal(decoder.asked, asked);
  }
});

test('brings the whole decoder when nobody has read for a while', ({ mock }) => {
  mock.timers.enable(['setTimeout']);
  const { decoder, succession } = waiting(PLAIN);
  succession.rest();
  mock.timers.tick(300);
  succession.begin(8000);
  mock.timers.tick(1000);
  assert.equal(decoder.asked, 0);
  succession.rest();
  mock.timers.tick(400);
  assert.equal(decoder.asked, 1);
});

test('brings the whole decoder when the model has come', async (t) => {
  serve(t, (one) => partOf(one, bytesUpTo(1000)));
  const decoder = new FakeDecoder([100, 1000]);
  const stream = new ArchiveStream(decoder.asDecoder, { archiveUrl: 'http://host/a.jsm', serverPlan: false }, ({ type }) => {
    if (type === 'picture') queueMicrotask(() => stream.drawn());
  });
  await stream.complete();
  assert.equal(decoder.prepared, 0);
  await new Promise((resolve) => setTimeout(resolve, 500));
  assert.equal(decoder.prepared, 1);
});

import assert from 'node:assert/strict';
import test from 'node:test';
import { Pictures } from '../../main/js/decode/pictures.js';
import { FakeDecoder } from './support/fake-decoder.js';

/** @param {import('node:test').TestContext} t */
function prepare(t) {
  const clock = { now: 1000, cost: 0 };
  t.mock.method(performance, 'now', () => (clock.now += clock.cost));
  const decoder = new FakeDecoder([100, 200, 300]);
  /** @type {any[]} */
  const posted = [];
  /** @type {ArrayBuffer[][]} */
  const transfers = [];
  const pictures = new Pictures(decoder.asDecoder, (message, transfer = []) => {
    posted.push(message);
    transfers.push(transfer);
  });
  return { clock, decoder, posted, transfers, pictures };
}

test('the first picture is due at once, the next when the one before is drawn and some time has passed', (t) => {
  const { clock, decoder, pictures } = prepare(t);
  assert.equal(pictures.isDue, true);
  decoder.batches = 1;
  pictures.show();
  clock.now += 10_000;
  assert.equal(pictures.isDue, false);
  pictures.drawn();
  assert.equal(pictures.isDue, true);
  clock.now -= 9_890;
  assert.equal(pictures.isDue, false);
});

test('a picture that was dear is followed by a longer pause', (t) => {
  const { clock, decoder, pictures } = prepare(t);
  decoder.batches = 1;
  clock.cost = 300;
  pictures.show();
  clock.cost = 0;
  pictures.drawn();
  clock.now += 1400;
  assert.equal(pictures.isDue, false);
  clock.now += 200;
  assert.equal(pictures.isDue, true);
});

test('a large part of the archive is worth a picture after a shorter pause', (t) => {
  const { clock, decoder, pictures } = prepare(t);
  Object.assign(decoder, { batches: 1, received: 100, header: { whole: true, archiveBytes: 2400 } });
  clock.cost = 300;
  pictures.show();
  clock.cost = 0;
  pictures.drawn();
  clock.now += 310;
  decoder.received = 199;
  assert.equal(pictures.isDue, false);
  decoder.received = 200;
  assert.equal(pictures.isDue, true);
  clock.now -= 20;
  assert.equal(pictures.isDue, false);
});

test('nothing is posted twice, and arrays are handed over', (t) => {
  const { decoder, posted, transfers, pictures } = prepare(t);
  const image = new Uint8Array(5);
  decoder.images = [[['a\nb.png', 'c.png'], image]];
  pictures.show();
  assert.equal(posted.length, 0);
  decoder.batches = 1;
  pictures.show();
  pictures.show();
  decoder.batches = 2;
  pictures.show();
  assert.deepEqual(posted.map(({ type }) => type), ['texture', 'picture', 'picture']);
  assert.deepEqual([posted[0].paths, transfers[0]], [['a\nb.png', 'c.png'], [image.buffer]]);
  assert.deepEqual([posted[1].batches, posted[2].batches], [1, 2]);
  const { ranges, data } = posted[1].changes;
  assert.deepEqual(transfers[1], [ranges.buffer, data.buffer]);
});

test('all is posted anew when the archive begins again', (t) => {
  const { decoder, posted, pictures } = prepare(t);
  decoder.images = [[['a.png'], new Uint8Array(5)]];
  decoder.batches = 1;
  pictures.show();
  pictures.reset();
  pictures.show();
  assert.deepEqual(posted.map(({ type }) => type), ['texture', 'picture', 'texture', 'picture']);
});

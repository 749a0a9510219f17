import assert from 'node:assert/strict';
import test from 'node:test';

/** A context in which everything succeeds, that counts the buffers it is given. */
function fakeContext() {
  let buffers = 0;
  const gl = new Proxy({}, { get: (_, name) => (name === 'bufferData' ? () => buffers++ : () => ({})) });
  return { gl, takeBuffers: () => [buffers, (buffers = 0)][0] };
}

/** @param {import('node:test').TestContext} context */
async function prepare(context) {
  const { gl, takeBuffers } = fakeContext();
  // There is one context, for the small renderer. three.js says that it gets none.
  const contexts = [gl];
  const canvas = () => ({ setAttribute() {}, addEventListener() {}, remove() {}, getContext: () => contexts.shift() ?? null });
  Object.assign(globalThis, { devicePixelRatio: 1, requestAnimationFrame() {}, document: { createElement: canvas, createElementNS: canvas } });
  context.after(() => ['devicePixelRatio', 'requestAnimationFrame', 'document'].forEach((name) => Reflect.deleteProperty(globalThis, name)));
  context.mock.method(console, 'error', () => {});
  const { ModelView } = await import('../../main/js/viewer/model-view.js');
  const view = new ModelView(/** @type {any} */ ({ append() {}, clientWidth: 300, clientHeight: 200 }), 'smooth');
  const open = (/** @type {number} */ faces) => {
    view.open(/** @type {any} */ ({ bounds: [0, 0, 0, 1, 1, 1], slots: [], channels: [], up: 'y', faces })).catch(() => {});
  };
  const show = (/** @type {number} */ faces) => {
    view.update(/** @type {any} */ ({ groups: [], vertices: 0, corners: 3 * faces, positions: new Float32Array(), normals: new Float32Array(), colours: [], indices: new Uint32Array(), isWhole: true }));
    return takeBuffers();
  };
  return { view, open, show };
}

test('leaves a large model to three.js, when enough of it is there', async (context) => {
  const { view, open, show } = await prepare(context);
  open(2e6);
  assert.ok(show(40_000) > 0 && show(49_000) > 0);
  const trouble = new Promise((resolve) => view.addEventListener('trouble', resolve));
  assert.equal(show(60_000), 0, 'it is not copied whole');
  await trouble;
  assert.ok(show(70_000) > 0, 'the small renderer goes on where three.js cannot');
});

test('draws a large model that is there from the start', async (context) => {
  const { view, open, show } = await prepare(context);
  view.takeOver = async () => {};
  open(2e6);
  assert.ok(show(2e6) > 0);
});

test('draws small models alone', async (context) => {
  const { view, open, show } = await prepare(context);
  view.takeOver = () => assert.fail('three.js is not needed');
  open(140_000);
  assert.ok(show(60_000) > 0 && show(140_000) > 0);
});

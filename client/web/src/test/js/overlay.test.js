import assert from 'node:assert/strict';
import test from 'node:test';
import { Overlay } from '../../main/js/page/marks/overlay.js';
import { Orbit } from '../../main/js/viewer/orbit.js';

/** @typedef {import('../../main/js/page/marks/overlay.js').Mark} Mark */

/** @type {(() => void)[]} */
const frames = [];

class FakeElement {
  setAttribute() {}
  append() {}
  remove() {}
}

Object.assign(globalThis, {
  SVGElement: class {},
  document: { createElement: () => new FakeElement(), createElementNS: () => new FakeElement() },
  requestAnimationFrame: (/** @type {() => void} */ frame) => frames.push(frame),
  ResizeObserver: class {
    observe() {}
    disconnect() {}
  },
});

test('marks stand where the picture of another window has them before its next frame', () => {
  const orbit = new Orbit();
  orbit.bounds = [-1, -1, -1, 1, 1, 1];
  const view = { orbit, size: { width: 1, height: 1, pixelRatio: 1 } };
  const fit = (/** @type {number} */ width, /** @type {number} */ height) => {
    view.size = { width, height, pixelRatio: 1 };
    orbit.refit(width, height);
  };
  fit(1000, 700);
  const overlay = new Overlay(/** @type {any} */ (new FakeElement()), /** @type {any} */ (view));
  /** @type {({ x: number, y: number } | null)[]} */
  const places = [];
  overlay.add(/** @type {Mark} */ ({ element: /** @type {any} */ (new FakeElement()), place: (project) => places.push(project([0.5, 0, 0])) }));
  for (const [width, height] of [[390, 844], [1000, 700]]) {
    fit(width, height);
    const at = places.at(-1);
    assert.ok(at && at.x > width / 2 && at.x < width && Math.abs(at.y - height / 2) < height / 8, JSON.stringify(at));
    while (frames.length > 0) frames.shift()?.();
    assert.deepEqual(places.at(-1), at);
  }
});

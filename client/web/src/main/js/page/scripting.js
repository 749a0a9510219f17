// @ts-check
// The page for scripts and tests.

/** @import { Figures } from '../session/figures.js' */
/** @import { Session } from '../session/session.js' */
/** @import { Shading } from '../session/shading.js' */
/** @import { ModelView } from '../viewer/model-view.js' */

/**
 * @param {Session} session
 * @param {ModelView | null} view
 */
export function scripting(session, view) {
  /** @type {(keyof Session)[]} */
  const ofSession = ['bytesPerSecond', 'decoder', 'rounds', 'pictures', 'texturesLoading', 'renewed'];
  /** @type {(keyof Figures)[]} */
  const ofArchive = ['state', 'faces', 'totalFaces', 'bytes', 'totalBytes', 'identical', 'proved', 'sha256', 'modelSha256', 'error', 'level', 'batches', 'header', 'errorMean', 'errorQuantile',
    'firstPicture', 'requests', 'keptBytes', 'isFull'];
  const jsm = {
    refine: () => session.refine(),
    complete: () => session.complete(),
    retry: () => session.retry(),
    stop: () => session.stop(),
    snapshot: (/** @type {number} */ width, /** @type {number} */ height) => view?.picture('image/png', { width, height }),
    frame: () => view?.orbit.frame(),
    setShading: (/** @type {Shading} */ value) => {
      if (view !== null) view.shading = value;
    },
  };
  for (const name of ofSession) Object.defineProperty(jsm, name, { get: () => session[name], enumerable: true });
  for (const name of ofArchive) Object.defineProperty(jsm, name, { get: () => session.figures[name], enumerable: true });
  Object.defineProperty(jsm, 'up', { get: () => view?.orbit.upright.axis });
  Object.defineProperty(jsm, 'camera', { get: () => (view === null ? undefined : cameraOf(view)) });
  Object.defineProperty(jsm, 'memory', { get: () => view?.memory });
  return jsm;
}

/**
 * The camera in the model's space, for checks against other renderers.
 *
 * @param {ModelView} view
 */
function cameraOf({ orbit }) {
  const { eye, target, fieldOfView } = orbit.camera;
  return { eye, target, up: [0, 1, 0], fieldOfView };
}

// How others use the package. Compiled by `npm run types`, never run.

import { LoadingManager, PerspectiveCamera, Scene } from 'three';
import { JsmLoader, type JsmModel } from 'jsm-viewer';
import 'jsm-viewer/viewer';

export async function show(scene: Scene, camera: PerspectiveCamera): Promise<JsmModel> {
  const loader = new JsmLoader(new LoadingManager()).setDecoderPath('/jsm/').setWithCredentials(true);
  const abort = new AbortController();
  const model = await loader.loadAsync('m/bunny/manifest.json', ({ loaded, total }) => console.log(loaded / total), { signal: abort.signal });
  scene.add(model);
  model.addEventListener('level', ({ level, faces }) => console.log(level + 1, faces + 1));
  model.addEventListener('identical', ({ meshSha256 }) => console.log(meshSha256.length));
  model.setTargetError(1, camera);
  await model.refine(2);
  await model.complete();
  loader.load('bunny.jsm', (other) => other.dispose());
  return model;
}

export function page(): void {
  const element = document.createElement('jsm-viewer');
  element.addEventListener('progress', ({ detail }) => console.log(detail.totalProgress + 1));
  element.addEventListener('click', () => element.refine(1));
  // @ts-expect-error the element has no such thing
  element.setTargetError(1);
}

// Draws GLB files by three's own loader, under the light of the viewer.

import * as THREE from './modules/vendor/three.module.min.js';
import { GLTFLoader } from './modules/vendor/GLTFLoader.js';
import { Lights } from './modules/three/lights.js';

const renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
renderer.setClearAlpha(0);
renderer.toneMapping = THREE.NeutralToneMapping;
renderer.toneMappingExposure = 0.92;
const stage = new THREE.Scene();
const lights = new Lights(stage, renderer);
lights.shading = 'smooth';

/**
 * Gives the picture as a data URL.
 *
 * @param {string} glb the file in base 64
 * @param {{ eye: number[], target: number[], up: number[], fieldOfView: number }} view
 * @param {number} width
 * @param {number} height
 */
async function draw(glb, view, width, height) {
  const bytes = Uint8Array.from(atob(glb), (char) => char.charCodeAt(0));
  const { scene } = await new GLTFLoader().parseAsync(bytes.buffer, '');
  const sphere = new THREE.Box3().setFromObject(scene, true).getBoundingSphere(new THREE.Sphere());
  const camera = new THREE.PerspectiveCamera(view.fieldOfView, width / height);
  camera.position.fromArray(view.eye);
  camera.up.fromArray(view.up);
  const target = new THREE.Vector3().fromArray(view.target);
  camera.lookAt(target);
  const distance = camera.position.distanceTo(target);
  camera.near = distance / 500;
  camera.far = distance + 40 * sphere.radius;
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
  lights.follow(camera, { center: sphere.center.toArray(), radius: sphere.radius });
  renderer.setSize(width, height, false);
  stage.add(scene);
  renderer.render(stage, camera);
  const url = renderer.domElement.toDataURL('image/png');
  stage.remove(scene);
  return url;
}

Object.assign(window, { draw });

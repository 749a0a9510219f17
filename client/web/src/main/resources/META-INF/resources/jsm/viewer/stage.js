// The three.js scene: one mesh that is refined, its materials, the light and the camera.

import * as THREE from './three/three.module.min.js';
import { OrbitControls } from './three/OrbitControls.js';
import { RoomEnvironment } from './three/RoomEnvironment.js';

/** Models without colours: warm in the studio's light, neutral in the matte one. */
const CLAY = [0.74, 0.71, 0.66];
const GREY = [0.8, 0.8, 0.8];
const FIELD_OF_VIEW = 35;
const START_DIRECTION = [0.55, 0.32, 1];
/** Share of the free part of the picture that the bounding box fills at first. */
const FILLED = 0.96;
/** Light of the matte shading, in linear values: from above, from below, and from over the viewer's left shoulder. */
const MATTE = { sky: [0.62, 0.64, 0.66], ground: [0.2, 0.19, 0.18], key: [0.5, 0.49, 0.46] };
const KEY_DIRECTION = [-0.6, 0.9, 0.7];
/** Room for render vertices that creases add to the wedges. */
const CREASE_ROOM = 1.3;

export class Stage {
  #renderer;
  #scene = new THREE.Scene();
  #camera = new THREE.PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 100);
  #controls = null;
  #rig = new THREE.Group();
  #sky = new THREE.HemisphereLight();
  #key = new THREE.DirectionalLight();
  #inset = { top: 0, bottom: 0 };
  #size = { width: 1, height: 1, pixelRatio: 1 };
  #mesh = null;
  #looks = [];
  #materials = [];
  #textures = new Map();
  #turns = new Map();
  #shownTurns = new Map();
  #shading = 'smooth';
  #wireframe = false;
  #dirty = false;
  #touched = false;
  #hasColours = false;
  #capacity = { vertices: 0, indices: 0, creases: false };
  #box = new THREE.Box3(new THREE.Vector3(-1, -1, -1), new THREE.Vector3(1, 1, 1));
  #sphere = new THREE.Sphere(new THREE.Vector3(), 1);

  /** Draws into a canvas; `interactive` adds orbit controls. */
  constructor(canvas, interactive, shading = 'smooth') {
    this.canvas = canvas;
    this.#shading = shading;
    this.#renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true, preserveDrawingBuffer: !interactive });
    this.#renderer.setClearAlpha(0);
    this.#renderer.toneMapping = THREE.NeutralToneMapping;
    this.#renderer.toneMappingExposure = 0.92;
    this.#scene.add(this.#rig, this.#sky, this.#key, this.#key.target);
    this.#light();
    if (interactive) this.#addControls();
  }

  /** Frames the model and makes its materials: `bounds` are smallest x, y, z, then largest. */
  open({ bounds, slots, wedges, faces, channels }) {
    this.#box.min.set(...bounds.slice(0, 3));
    this.#box.max.set(...bounds.slice(3, 6));
    this.#box.getBoundingSphere(this.#sphere);
    if (this.#sphere.radius === 0) this.#sphere.radius = 1;
    this.#looks = slots;
    this.#hasColours = channels.some((c) => c.semantic === 'COLOUR');
    this.#capacity = { vertices: wedges, indices: 3 * faces, creases: !channels.some((c) => c.semantic === 'NORMAL') };
    this.#makeMaterials();
    this.frame();
  }

  /** Puts the whole model into the part of the picture that nothing covers, seen from the front and slightly above. */
  frame() {
    const { center, radius } = this.#sphere;
    this.#camera.position.set(...START_DIRECTION).add(center);
    this.#camera.up.set(0, 1, 0);
    this.#camera.lookAt(center);
    const distance = this.#framingDistance();
    this.#camera.near = radius / 200;
    this.#camera.far = distance + 40 * radius;
    this.#camera.position.sub(center).setLength(distance).add(center);
    this.#camera.updateProjectionMatrix();
    if (this.#controls) {
      this.#controls.target.copy(center);
      this.#controls.minDistance = radius / 50;
      this.#controls.maxDistance = 20 * radius;
      this.#controls.update();
    }
    this.invalidate();
  }

  /** From where on all corners of the box are in the picture. */
  #framingDistance() {
    const { width, height } = this.#size;
    const slope = FILLED * Math.tan(THREE.MathUtils.degToRad(FIELD_OF_VIEW / 2));
    const free = Math.max(height - this.#inset.top - this.#inset.bottom, height / 3);
    const toEye = this.#camera.quaternion.clone().invert();
    let distance = 0;
    for (let i = 0; i < 8; i++) {
      const pick = (axis) => (i & (1 << axis) ? this.#box.max : this.#box.min).getComponent(axis);
      const corner = new THREE.Vector3(pick(0), pick(1), pick(2)).sub(this.#sphere.center);
      corner.applyEuler(this.#rig.rotation).applyQuaternion(toEye);
      const across = (Math.abs(corner.x) * height) / width;
      const along = (Math.abs(corner.y) * height) / free;
      distance = Math.max(distance, corner.z + Math.max(across, along) / slope);
    }
    return distance;
  }

  /** Shows the arrays of a finer mesh. */
  update({ vertices, positions, normals, uvs, colours, indices, groups }) {
    const room = this.#mesh?.geometry;
    if (!room || vertices > room.getAttribute('position').count || indices.length > room.index.count) {
      this.#allocate(vertices, indices.length, uvs, colours);
    }
    const { geometry } = this.#mesh;
    fill(geometry.getAttribute('position'), positions);
    fill(geometry.getAttribute('normal'), normals);
    if (uvs.length > 0) fill(geometry.getAttribute('uv'), uvs);
    if (colours.length > 0) fill(geometry.getAttribute('color'), new Uint8Array(colours.buffer));
    fill(geometry.index, indices);
    geometry.clearGroups();
    for (let i = 0; i < groups.length; i += 3) {
      if (groups[i + 2] > 0) geometry.addGroup(groups[i + 1], groups[i + 2], groups[i]);
    }
    geometry.setDrawRange(0, indices.length);
    this.invalidate();
  }

  /** A texture has arrived whole, or a preview of it. */
  async addTexture(path, bytes) {
    const turn = (this.#turns.get(path) ?? 0) + 1;
    this.#turns.set(path, turn);
    const gltf = this.#looks.some((look) => look.texture === path && look.gltf);
    const image = await createImageBitmap(new Blob([bytes]), { imageOrientation: gltf ? 'none' : 'flipY', premultiplyAlpha: 'none' });
    // A better image may have been ready sooner.
    if (turn < (this.#shownTurns.get(path) ?? 0)) return;
    this.#shownTurns.set(path, turn);
    const texture = new THREE.Texture(image);
    texture.flipY = false;
    texture.colorSpace = THREE.SRGBColorSpace;
    texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
    texture.anisotropy = Math.min(8, this.#renderer.capabilities.getMaxAnisotropy());
    texture.needsUpdate = true;
    const before = this.#textures.get(path);
    this.#textures.set(path, texture);
    this.#makeMaterials();
    before?.dispose();
  }

  /** 'smooth', 'flat', 'matte' (plain diffuse light) or 'normals' (each face in the colour of its direction). */
  set shading(value) {
    this.#shading = value;
    this.#light();
    this.#makeMaterials();
  }

  set wireframe(on) {
    this.#wireframe = on;
    this.#makeMaterials();
  }

  /** 'y' or 'z'. */
  set up(axis) {
    this.#rig.rotation.x = axis === 'z' ? -Math.PI / 2 : 0;
    this.#placeRig();
    this.frame();
  }

  /** Turns the camera around the model, in radians. */
  turn(right, up) {
    this.#touched = true;
    const offset = this.#camera.position.clone().sub(this.#controls.target);
    const spherical = new THREE.Spherical().setFromVector3(offset);
    spherical.theta += right;
    spherical.phi = THREE.MathUtils.clamp(spherical.phi + up, 0.02, Math.PI - 0.02);
    this.#camera.position.setFromSpherical(spherical).add(this.#controls.target);
    this.#controls.update();
  }

  zoom(factor) {
    this.#touched = true;
    const { target, minDistance, maxDistance } = this.#controls;
    const offset = this.#camera.position.clone().sub(target);
    offset.setLength(THREE.MathUtils.clamp(offset.length() * factor, minDistance, maxDistance));
    this.#camera.position.copy(target).add(offset);
    this.#controls.update();
  }

  /** Fits the drawing buffer to the canvas on the page, of which some pixels at the top and the bottom lie below other things. */
  resize(width, height, pixelRatio, inset = this.#inset) {
    if (width === 0 || height === 0) return;
    this.#size = { width, height, pixelRatio };
    this.#inset = inset;
    this.#renderer.setPixelRatio(pixelRatio);
    this.#renderer.setSize(width, height, false);
    this.#camera.aspect = width / height;
    const shift = (inset.bottom - inset.top) / 2;
    if (shift === 0) this.#camera.clearViewOffset();
    else this.#camera.setViewOffset(width, height, 0, shift, width, height);
    this.#camera.updateProjectionMatrix();
    // Until somebody has turned the model it stays framed.
    if (!this.#touched) this.frame();
    this.invalidate();
  }

  /** Draws at the next frame. */
  invalidate() {
    if (this.#dirty) return;
    this.#dirty = true;
    requestAnimationFrame(() => this.render());
  }

  /** Draws now. */
  render() {
    this.#dirty = false;
    // The light comes over the viewer's left shoulder, wherever the camera is.
    const { center, radius } = this.#sphere;
    this.#key.position.set(...KEY_DIRECTION).applyQuaternion(this.#camera.quaternion).multiplyScalar(3 * radius).add(center);
    this.#key.target.position.copy(center);
    this.#renderer.render(this.#scene, this.#camera);
    if (this.#mesh !== null) {
      for (const attribute of [...Object.values(this.#mesh.geometry.attributes), this.#mesh.geometry.index]) attribute.clearUpdateRanges();
    }
  }

  /** The picture on a transparent background as a data URL, at a size in pixels or that of the page. */
  picture(type = 'image/png', width = null, height = null) {
    const { width: w, height: h, pixelRatio } = this.#size;
    const inset = this.#inset;
    const touched = this.#touched;
    this.#touched = true;
    if (width !== null) this.resize(width, height, 1, { top: 0, bottom: 0 });
    this.render();
    const url = this.canvas.toDataURL(type);
    if (width !== null) this.resize(w, h, pixelRatio, inset);
    this.#touched = touched;
    return url;
  }

  /** The camera in the model's space, for checks against other renderers. */
  get camera() {
    const target = this.#controls ? this.#controls.target : this.#sphere.center;
    return { eye: this.#camera.position.toArray(), target: target.toArray(), up: this.#camera.up.toArray(), fieldOfView: FIELD_OF_VIEW };
  }

  /** What the graphics card holds now. */
  get memory() {
    return { ...this.#renderer.info.memory };
  }

  /** Takes the model off the stage and frees what it held. */
  clear() {
    if (this.#mesh !== null) {
      this.#rig.remove(this.#mesh);
      this.#mesh.geometry.dispose();
      this.#mesh = null;
    }
    this.#textures.forEach((texture) => texture.dispose());
    this.#textures.clear();
    this.#turns.clear();
    this.#shownTurns.clear();
    this.#materials.forEach((material) => material.dispose());
    this.#materials = [];
  }

  dispose() {
    this.clear();
    this.#controls?.dispose();
    this.#scene.environment?.dispose();
    this.#renderer.dispose();
    this.#renderer.forceContextLoss();
  }

  #addControls() {
    this.#controls = new OrbitControls(this.#camera, this.canvas);
    this.#controls.enableDamping = true;
    this.#controls.dampingFactor = 0.12;
    let until = 0;
    this.canvas.addEventListener('pointerdown', () => (this.#touched = true));
    this.canvas.addEventListener('wheel', () => (this.#touched = true), { passive: true });
    const follow = () => {
      this.#controls.update();
      if (performance.now() < until) requestAnimationFrame(follow);
    };
    this.#controls.addEventListener('start', () => (until = Infinity) && requestAnimationFrame(follow));
    this.#controls.addEventListener('end', () => (until = performance.now() + 700));
    this.#controls.addEventListener('change', () => this.invalidate());
  }

  #light() {
    const matte = this.#shading === 'matte';
    if (matte) {
      // Linear values times π, because a matte surface sends out a πth of what it receives.
      this.#sky.color.setRGB(...MATTE.sky);
      this.#sky.groundColor.setRGB(...MATTE.ground);
      this.#key.color.setRGB(...MATTE.key);
    } else {
      this.#sky.color.set(0xffffff);
      this.#sky.groundColor.set(0x8d8478);
      this.#key.color.set(0xfff4e6);
      this.#scene.environment ??= this.#studio();
      this.#scene.environmentIntensity = 0.45;
    }
    this.#sky.intensity = matte ? Math.PI : 0.55;
    this.#key.intensity = matte ? Math.PI : 2.1;
  }

  /** Soft light from all sides, as in a photographer's room; small, because it is blurred anyway. */
  #studio() {
    const generator = new THREE.PMREMGenerator(this.#renderer);
    const room = new RoomEnvironment();
    const { texture } = generator.fromScene(room, 0.04, 0.1, 100, { size: 128 });
    room.dispose();
    generator.dispose();
    return texture;
  }

  /** Turns the model about its middle, so that the framing stays. */
  #placeRig() {
    const { center } = this.#sphere;
    this.#rig.position.set(0, 0, 0);
    this.#rig.updateMatrixWorld();
    this.#rig.position.copy(center).sub(center.clone().applyEuler(this.#rig.rotation));
  }

  /** Buffers of the graphics card cannot grow, so they are made for the whole model at once. */
  #allocate(vertices, corners, uvs, colours) {
    const { vertices: total, indices, creases } = this.#capacity;
    const room = Math.max(Math.ceil(total * (creases && this.#mesh !== null ? CREASE_ROOM : 1)), vertices);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', dynamic(new Float32Array(3 * room), 3));
    geometry.setAttribute('normal', dynamic(new Float32Array(3 * room), 3));
    if (uvs.length > 0) geometry.setAttribute('uv', dynamic(new Float32Array(2 * room), 2));
    if (colours.length > 0) geometry.setAttribute('color', dynamic(new Uint8Array(4 * room), 4, true));
    geometry.setIndex(dynamic(new Uint32Array(Math.max(indices, corners)), 1));
    geometry.boundingSphere = this.#sphere.clone();
    if (this.#mesh === null) {
      this.#mesh = new THREE.Mesh(geometry, this.#materials);
      this.#mesh.frustumCulled = false;
      this.#rig.add(this.#mesh);
    } else {
      this.#mesh.geometry.dispose();
      this.#mesh.geometry = geometry;
    }
  }

  #makeMaterials() {
    const before = this.#materials;
    this.#materials = this.#looks.map((look) => this.#material(look));
    if (this.#mesh !== null) this.#mesh.material = this.#materials;
    before.forEach((material) => material.dispose());
    this.invalidate();
  }

  #material(look) {
    const side = THREE.DoubleSide;
    if (this.#shading === 'normals') return new THREE.MeshNormalMaterial({ flatShading: true, side, wireframe: this.#wireframe });
    const map = this.#textures.get(look.texture) ?? null;
    const common = { map, side, wireframe: this.#wireframe, flatShading: this.#shading === 'flat', vertexColors: this.#hasColours };
    const roughness = look.roughness >= 0 ? look.roughness : 0.62;
    const metalness = look.metallic >= 0 ? look.metallic : 0;
    const material =
      this.#shading === 'matte'
        ? new THREE.MeshLambertMaterial({ ...common, toneMapped: false })
        : new THREE.MeshStandardMaterial({ ...common, roughness, metalness });
    const [r, g, b, alpha] = look.colour ?? (this.#hasColours || look.texture ? [1, 1, 1, 1] : [...(this.#shading === 'matte' ? GREY : CLAY), 1]);
    material.color.setRGB(r, g, b, look.gltf ? THREE.LinearSRGBColorSpace : THREE.SRGBColorSpace);
    // Many MTL files give a textured material a black or grey Kd that no viewer applies.
    if (map !== null && !look.gltf) material.color.setRGB(1, 1, 1);
    if (alpha < 1) {
      material.transparent = true;
      material.opacity = alpha;
      material.depthWrite = false;
    }
    if (this.#hasColours) material.onBeforeCompile = decodeColours;
    return material;
  }
}

/** Vertex colours come in sRGB bytes; light is reckoned in linear values. */
function decodeColours(shader) {
  shader.vertexShader = shader.vertexShader.replace(
    '#include <color_vertex>',
    `#include <color_vertex>
    vColor.rgb = mix(pow((vColor.rgb + 0.055) / 1.055, vec3(2.4)), vColor.rgb / 12.92, vec3(lessThanEqual(vColor.rgb, vec3(0.04045))));`,
  );
}

function dynamic(array, itemSize, normalized = false) {
  return new THREE.BufferAttribute(array, itemSize, normalized).setUsage(THREE.DynamicDrawUsage);
}

function fill(attribute, values) {
  attribute.array.set(values);
  attribute.clearUpdateRanges();
  attribute.addUpdateRange(0, values.length);
  attribute.needsUpdate = true;
}

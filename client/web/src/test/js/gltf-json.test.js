// @ts-check
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { gltfOf, modern } from '../../main/js/three/gltf-json.js';

const NEAREST = { magFilter: 9728 };

test('textures are lifted out of their materials, each once', () => {
  const image = { index: { source: 0, sampler: NEAREST } };
  const { json, uses } = gltfOf([
    { gltf: { pbrMetallicRoughness: { baseColorTexture: image, metallicFactor: 0 } }, images: ['a.png'] },
    { gltf: { pbrMetallicRoughness: { baseColorTexture: { ...image, texCoord: 1 } } }, images: ['a.png'] },
  ]);
  assert.deepEqual(json.materials, [
    { pbrMetallicRoughness: { baseColorTexture: { index: 0 }, metallicFactor: 0 } },
    { pbrMetallicRoughness: { baseColorTexture: { index: 0, texCoord: 1 } } },
  ]);
  assert.deepEqual(uses, [{ path: 'a.png', sampler: NEAREST, kind: 'colour' }]);
  assert.equal(json.textures.length, 1);
});

test('an image with two samplers or two meanings makes two textures', () => {
  const { uses } = gltfOf([
    {
      gltf: {
        pbrMetallicRoughness: { baseColorTexture: { index: { source: 0 } }, metallicRoughnessTexture: { index: { source: 0 } } },
        emissiveTexture: { index: { source: 0, sampler: NEAREST } },
        normalTexture: { index: { source: 1 } },
        occlusionTexture: { index: { source: 0 } },
      },
      images: ['a.png', 'b.png'],
    },
  ]);
  assert.deepEqual(uses, [
    { path: 'a.png', sampler: {}, kind: 'colour' },
    { path: 'a.png', sampler: {}, kind: 'data' },
    { path: 'a.png', sampler: NEAREST, kind: 'emission' },
    { path: 'b.png', sampler: {}, kind: 'normal' },
  ]);
});

test('textures of extensions are lifted, and all else of them is kept', () => {
  const transform = { KHR_texture_transform: { offset: [0.5, 0] } };
  const { json, uses } = gltfOf([
    {
      gltf: {
        alphaMode: 'BLEND',
        extensions: { KHR_materials_clearcoat: { clearcoatFactor: 0.5, clearcoatTexture: { index: { source: 0 }, extensions: transform } } },
        extras: { index: { source: 0 } },
      },
      images: ['a.png'],
    },
  ]);
  const clearcoatTexture = { index: 0, extensions: transform };
  assert.deepEqual(json.materials, [
    { alphaMode: 'BLEND', extensions: { KHR_materials_clearcoat: { clearcoatFactor: 0.5, clearcoatTexture } } },
  ]);
  assert.equal(uses[0].kind, 'data');
});

test('a texture without an image, or with coordinates that nobody draws, is left out', () => {
  const { json, uses } = gltfOf([
    { gltf: { emissiveTexture: { index: {} }, normalTexture: { index: { source: 0 }, texCoord: 4 } }, images: ['a.png'] },
  ]);
  assert.deepEqual(json.materials, [{}]);
  assert.deepEqual(uses, []);
});

test('the image that every viewer reads is taken before one in another format', () => {
  const webp = { EXT_texture_webp: { source: 1 } };
  const images = ['a.png', 'a.webp'];
  const pathOf = (/** @type {object} */ index) => gltfOf([{ gltf: { normalTexture: { index } }, images }]).uses[0].path;
  assert.equal(pathOf({ source: 0, extensions: webp }), 'a.png');
  assert.equal(pathOf({ extensions: webp }), 'a.webp');
  assert.equal(pathOf({ extensions: { KHR_texture_basisu: { source: 1 } } }), 'a.webp');
});

const OLD = {
  diffuseFactor: [0.5, 0.25, 0, 1],
  diffuseTexture: { index: { source: 0 } },
  specularFactor: [0.1, 0.2, 0.3],
  glossinessFactor: 0.75,
};

test('specular and glossiness become a surface without metal', () => {
  const converted = modern({ doubleSided: true, extensions: { KHR_materials_pbrSpecularGlossiness: OLD } });
  assert.deepEqual(converted, {
    doubleSided: true,
    pbrMetallicRoughness: { metallicFactor: 0, roughnessFactor: 0.25, baseColorFactor: [0.5, 0.25, 0, 1], baseColorTexture: OLD.diffuseTexture },
    extensions: { KHR_materials_ior: { ior: 1000 }, KHR_materials_specular: { specularColorFactor: [0.1, 0.2, 0.3] } },
  });
});

test('an image of specular and glossiness is read as colour and as the contrary of roughness', () => {
  const specularGlossinessTexture = { index: { source: 0 } };
  const converted = modern({ extensions: { KHR_materials_pbrSpecularGlossiness: { ...OLD, specularGlossinessTexture } } });
  assert.equal(converted.pbrMetallicRoughness.roughnessFactor, 1);
  const { json, uses } = gltfOf([{ gltf: converted, images: ['a.png'] }]);
  assert.deepEqual(json.materials[0].pbrMetallicRoughness.metallicRoughnessTexture, { index: 1 });
  assert.deepEqual(uses, [
    { path: 'a.png', sampler: {}, kind: 'colour' },
    { path: 'a.png', sampler: {}, kind: 'data', glossiness: 0.75 },
  ]);
});

test('a surface that the file gives in today’s words is left alone', () => {
  const material = { pbrMetallicRoughness: { metallicFactor: 0.5 }, extensions: { KHR_materials_pbrSpecularGlossiness: OLD } };
  assert.equal(modern(material), material);
  assert.deepEqual(modern({}), {});
});

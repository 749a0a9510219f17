import assert from 'node:assert/strict';
import test from 'node:test';
import { addressOf, jarIn, launchUrl, lines, systemOf } from '../../main/js/page/tools/desktop-ways.js';

const SHA = '0a'.repeat(32);
const BASE = 'https://example.org/meshes/';
const ARCHIVE = `${BASE}m/chair/${SHA}.jsm`;

test('tells systems apart by what browsers say', () => {
  assert.equal(systemOf('Linux x86_64'), 'Linux');
  assert.equal(systemOf('Win32'), 'Windows');
  assert.equal(systemOf('Windows'), 'Windows');
  assert.equal(systemOf('MacIntel'), 'macOS');
  assert.equal(systemOf(''), 'other');
});

test('gives the viewer the manifest where there is one', () => {
  const manifest = `${BASE}m/chair/manifest.json`;
  assert.equal(addressOf(ARCHIVE, '?m=chair', BASE, undefined), manifest);
  assert.equal(addressOf(ARCHIVE, '', BASE, 'm/chair/manifest.json'), manifest);
  assert.equal(addressOf('https://store.example/a.jsm?v=1', '?archive=x', BASE, undefined), 'https://store.example/a.jsm?v=1');
  assert.equal(addressOf(ARCHIVE, '?archive=x', BASE, 'm/other/manifest.json'), ARCHIVE);
});

test('hands on the signature of the page', () => {
  assert.equal(addressOf(ARCHIVE, '?m=chair&up=y&expires=7&signature=a-_', BASE, undefined), `${BASE}m/chair/manifest.json?expires=7&signature=a-_`);
  const signed = `${BASE}m/chair/manifest.json?expires=7&signature=a`;
  assert.equal(launchUrl(signed), `${BASE}m/chair/viewer.jnlp?expires=7&signature=a`);
});

test('gives nobody the address of a file of the device', () => {
  assert.equal(addressOf('blob:https://example.org/1', '?file=a.jsm', BASE, 'm/chair/manifest.json'), null);
  assert.equal(addressOf('', '', BASE, undefined), null);
});

test('gives the manifest before anything of the model is there', () => {
  assert.equal(addressOf('', '?m=chair', BASE, undefined), `${BASE}m/chair/manifest.json`);
  assert.equal(addressOf('', '', BASE, 'm/chair/manifest.json'), `${BASE}m/chair/manifest.json`);
});

test('asks only for models of servers how the viewer is started', () => {
  assert.equal(launchUrl('https://store.example/a.jsm'), null);
});

test('finds the viewer in what the server says', () => {
  const text = `<jnlp><resources>\n<jar href=".viewer/${SHA}/jsm-viewer.jar" main="true" size="11202887"/></resources></jnlp>`;
  const address = `${BASE}m/chair/manifest.json?signature=a`;
  assert.deepEqual(jarIn(text, address), { url: `${BASE}m/.viewer/${SHA}/jsm-viewer.jar`, bytes: 11202887 });
  assert.equal(jarIn('<html></html>', address), null);
});

test('writes lines that a shell takes as they are', () => {
  const jar = { url: `${BASE}m/.viewer/${SHA}/jsm-viewer.jar`, bytes: 1 };
  const address = `${BASE}m/a/manifest.json?expires=1&signature=b'$(x)\``;
  assert.equal(lines('Linux', address, jar), `curl -fLO '${jar.url}'\njava -jar jsm-viewer.jar '${BASE}m/a/manifest.json?expires=1&signature=b%27%24(x)%60'`);
  assert.equal(lines('Windows', `${BASE}m/a/manifest.json`, null), `java -jar jsm-viewer.jar "${BASE}m/a/manifest.json"`);
});

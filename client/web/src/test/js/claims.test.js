import assert from 'node:assert/strict';
import test from 'node:test';
import { claims } from '../../main/js/session/claims.js';
import { Figures } from '../../main/js/session/figures.js';

const WHOLE = { claim: 'identical to the original file', warning: false, notKept: '' };

/** @param {object} words */
function proved(words) {
  const figures = new Figures();
  figures.take({ type: 'header', header: /** @type {any} */ ({ whole: true, archiveBytes: 10, words }) });
  figures.take({ type: 'proved', meshSha256: 'of the mesh', modelSha256: 'of the model' });
  return figures;
}

test('nothing is claimed before it is proved', () => {
  const figures = new Figures();
  figures.take({ type: 'header', header: /** @type {any} */ ({ whole: true, archiveBytes: 10, words: WHOLE }) });
  assert.deepEqual(claims(figures), { badge: '', isWarning: false, title: '', line: '' });
  assert.equal(figures.identical, false);
});

test('what lost nothing is identical, without a word more', () => {
  const figures = proved(WHOLE);
  const { badge, isWarning, title, line } = claims(figures);
  assert.deepEqual([badge, isWarning, line], ['identical to the original', false, '']);
  assert.equal(title, 'Identical to the original file. SHA-256 of the decoded mesh: of the mesh; of mesh and pictures: of the model');
  assert.equal(figures.identical, true);
});

test('what lost something that is not seen is identical, and says what is lost', () => {
  const figures = proved({ ...WHOLE, notKept: 'of the file not kept: 3 group names' });
  const { badge, line } = claims(figures);
  assert.deepEqual([badge, line], ['identical to the original', 'Of the file not kept: 3 group names.']);
  assert.equal(figures.identical, true);
});

test('what lost something that is seen is never identical, and the sign does not stand on colour alone', () => {
  const figures = proved({ claim: 'not the whole original: 124 parts missing', warning: true, notKept: 'of the file not kept: animations' });
  const { badge, isWarning, line } = claims(figures);
  assert.deepEqual([badge, isWarning], ['not the whole original', true]);
  assert.equal(line, '\u26a0 Not the whole original: 124 parts missing. Of the file not kept: animations.');
  assert.equal(figures.identical, false);
});

test('what a batch means is unknown until the index of the archive is', () => {
  const figures = new Figures();
  figures.batches = 2;
  figures.header = /** @type {any} */ ({ batchLevels: [], errorMeans: [] });
  assert.deepEqual([figures.level, figures.errorMean], [0, null]);
  figures.header = /** @type {any} */ ({ batchLevels: [0, 3], errorMeans: [0.5, 0.25] });
  assert.deepEqual([figures.level, figures.errorMean], [3, 0.25]);
});

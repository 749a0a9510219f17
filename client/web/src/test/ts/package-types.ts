// The types of the package are those of the sources. Compiled by `npm run types`, never run.

import * as loader from '../../main/js/three/jsm-loader.js';
import * as viewer from '../../main/js/viewer/jsm-viewer.js';
import type { JsmLoader, JsmModel } from '../../main/npm/jsm-loader.js';
import type { JsmViewerElement } from '../../main/npm/jsm-viewer.js';

type Public<T> = { [K in keyof T]: T[K] };

export const aLoader = (made: loader.JsmLoader): Omit<Public<JsmLoader>, 'loadAsync' | 'load'> => made;
export const loads = (made: loader.JsmLoader): Promise<loader.JsmModel> => made.loadAsync('url', () => {}, { signal: new AbortController().signal });
export const aModel = (made: loader.JsmModel): Omit<Public<JsmModel>, keyof import('three').Object3D> => made;
export const anElement = (made: viewer.JsmViewerElement): Omit<Public<JsmViewerElement>, keyof HTMLElement> => made;
export const preloads: () => Promise<void> = viewer.JsmViewerElement.preload;

// What is told of one is true of the other.
export const constructors: [new (manager?: import('three').LoadingManager) => Pick<JsmLoader, 'setDecoderPath'>] = [loader.JsmLoader];

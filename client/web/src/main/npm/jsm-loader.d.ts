// Types of jsm-loader.js.

import type { Box3, Camera, Group, Loader, LoadingManager, Object3DEventMap } from 'three';

export type Shading = 'smooth' | 'flat' | 'matte' | 'normals';

export interface JsmModelEventMap extends Object3DEventMap {
  /** Bytes of the archive, 0 to 1. */
  progress: { totalProgress: number };
  /** What is shown has changed. */
  level: { level: number; faces: number };
  /** It has stopped at what the device is given: see `maxFaces`. */
  budget: { faces: number };
  /** The original is there. */
  complete: {};
  error: { message: string };
  /** Mesh and pictures are those that were encoded. */
  identical: { meshSha256: string; modelSha256: string };
  /** Something about the picture has changed: draw it again. */
  change: {};
}

/** What is known of a model and of what has arrived of it. */
export interface Figures {
  readonly state: 'loading' | 'refining' | 'idle' | 'complete' | 'error';
  readonly faces: number;
  readonly totalFaces: number;
  readonly bytes: number;
  readonly totalBytes: number;
  readonly level: number;
  /** Mean distance to the original in percent of the diagonal; null before there is a mesh. */
  readonly errorMean: number | null;
  /** Distance to the original that 99.9% of the surface does not exceed, likewise. */
  readonly errorQuantile: number | null;
  /** In words. */
  readonly error: string | null;
}

/** A model as a group of a scene, which refines itself. */
export class JsmModel extends Group<JsmModelEventMap> {
  private constructor();
  /** The bounds of the model as it stands in the group. */
  readonly bounds: Box3;
  readonly figures: Figures;
  readonly bytesPerSecond: number;
  set shading(value: Shading);
  set wireframe(on: boolean);
  /** One more round of so many seconds; resolves when it is over. */
  refine(seconds?: number): Promise<void>;
  /** The original; resolves when it is there. */
  complete(): Promise<void>;
  /** Gives up what is being loaded; what has arrived stays. */
  stop(): void;
  /** After so many faces it stops refining; a larger number lets it go on. */
  set maxFaces(faces: number);
  /** Refines by itself until 99.9% of the surface is off by no more pixels; null ends that. */
  setTargetError(pixels: number | null, camera?: Camera | null): void;
  /** How far 99.9% of the surface is off at most in a picture, in pixels. */
  pixelError(seen: { width: number; height: number; camera: Camera }): number;
  /** Frees what it holds. */
  dispose(): void;
}

export interface LoadOptions {
  signal?: AbortSignal;
}

/** Loads streamed models: addresses of manifests (`.../manifest.json`) or archives (`.jsm`). */
export class JsmLoader extends Loader<JsmModel> {
  constructor(manager?: LoadingManager);
  /** The folder of `jsm-worker.js` and `jsm-decoder.*`, if they do not lie beside `jsm-loader.js`. */
  setDecoderPath(path: string): this;
  setDecoder(kind: 'auto' | 'wasm' | 'js'): this;
  /** The time that a round takes. */
  setWaitSeconds(seconds: number): this;
  /** After so many faces a model stops refining; Infinity for no limit. Else that depends on the device's memory. */
  setMaxFaces(faces: number): this;
  load(url: string, onLoad?: (model: JsmModel) => void, onProgress?: (event: ProgressEvent) => void, onError?: (error: unknown) => void, options?: LoadOptions): void;
  /** Resolves when there is something to see. */
  loadAsync(url: string, onProgress?: (event: ProgressEvent) => void, options?: LoadOptions): Promise<JsmModel>;
  /** Gives up what has no picture yet. */
  abort(): this;
  dispose(): void;
}

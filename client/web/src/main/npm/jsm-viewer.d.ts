// Types of jsm-viewer.js.

/** What the events of the element carry in `detail`. */
export interface JsmViewerEventMap {
  load: { url: string | null };
  progress: { totalProgress: number };
  level: { level: number; faces: number };
  /** It has stopped at what the device is given: see `max-faces`. */
  budget: { faces: number };
  complete: undefined;
  error: { type: 'loadfailure'; message: string };
  identical: { meshSha256: string; modelSha256: string };
  'camera-change': undefined;
  'model-visibility': { visible: boolean };
  'poster-dismissed': undefined;
}

/** `<jsm-viewer src="m/ID/manifest.json" camera-controls>` */
export class JsmViewerElement extends HTMLElement {
  /** Loads three.js ahead, for pages that will show a model later. */
  static preload(): Promise<void>;
  /** Whether there is something to see. */
  readonly loaded: boolean;
  /** One more round of so many seconds; resolves when it is over. */
  refine(seconds?: number): Promise<void>;
  /** The original; resolves when it is there. */
  complete(): Promise<void>;
  /** Tries again what failed. */
  retry(): Promise<void>;
  /** Gives up what is being loaded; what has arrived stays. */
  stop(): void;
  showPoster(): void;
  dismissPoster(): void;
  /** Shows all of the model, as at first. */
  frame(): void;
  /** Radians, and lengths of the model. */
  getCameraOrbit(): { theta: number; phi: number; radius: number };
  getCameraTarget(): { x: number; y: number; z: number };
  jumpCameraToGoal(): void;
  /** The picture on a transparent background. */
  toDataURL(type?: string): string;
  addEventListener<K extends keyof JsmViewerEventMap>(type: K, listener: (event: CustomEvent<JsmViewerEventMap[K]>) => void, options?: boolean | AddEventListenerOptions): void;
  addEventListener(type: string, listener: EventListenerOrEventListenerObject, options?: boolean | AddEventListenerOptions): void;
}

declare global {
  interface HTMLElementTagNameMap {
    'jsm-viewer': JsmViewerElement;
  }
}

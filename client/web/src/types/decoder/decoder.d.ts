// What DecoderMain exports; the build compiles it to this place. Each string is JSON: see Answer.java.
export interface Java {
  open(): string;
  staging(): Int8Array<ArrayBuffer>;
  feed(length: number): string;
  header(): string;
  isComplete(): string;
  refine(): string;
  copy(from: number): string;
  images(): string;
  copyImage(image: number, from: number): string;
  sha256(): string;
  proof(): string;
  beginRound(now: number, waitMillis: number): string;
  nextRequest(now: number, receivedBytes: number): string;
  isOver(now: number): string;
  beginResponse(now: number): string;
  arrived(now: number, bytes: number): string;
  endResponse(cached: boolean): string;
  mayGoOn(now: number, bytesLeft: number): string;
  bytesPerSecond(now: number): string;
}

/** Makes a decoder with a memory of its own. */
export function instantiate(): Java;

// What FirstDecoderMain exports: the same as far as it goes.
import type { Java } from './decoder.js';

export function instantiate(): Java;

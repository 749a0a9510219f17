/** Measures how far levels of detail are from the original, and fits their vertices to it. */
package org.jsmesh.encode.measure;

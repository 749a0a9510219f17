/** Doubles, integers and attributes of faces: what float32 does not hold, coded at the end of an archive. */
package org.jsmesh.codec.exact;

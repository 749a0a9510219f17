/** Mesh in, archive out: runs the simplification, codes its passes and indexes the batches. */
package org.jsmesh.encode;

/** Which batches to ask for: the byte budget of a wait at an estimated throughput, snapped to whole batches. */
package org.jsmesh.batch;

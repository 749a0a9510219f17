/** Estimates the throughput and plans which batches to ask for: the byte budget of a wait, snapped to whole batches. */
package org.jsmesh.plan;

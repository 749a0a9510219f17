/**
 * A load test: many viewers of mixed bandwidths on one server, with faults. {@code docs/benchmarks.md}, section Load,
 * says how to run the long one.
 */
package org.jsmesh.load;

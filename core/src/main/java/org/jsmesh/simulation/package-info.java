/**
 * Simulated clients and links in virtual time. They show what a planner of batches brings, without a network and
 * without waiting.
 *
 * <pre>{@code
 * SimulatedVisitor visitor = SimulatedVisitor.of(decoder.index(), LinkTrace.named("lte"), 1, HttpVersion.HTTP_2, 60);
 * for (int round = 1; round <= 5; round++) {
 *     SimulatedVisitor.Round seen = visitor.refine(2000);
 *     System.out.println(seen.bytes() + " bytes after " + seen.waitMillis() + " ms more");
 * }
 * }</pre>
 */
package org.jsmesh.simulation;

/**
 * Estimates the throughput and plans which batches to ask for: the byte budget of a wait, snapped to whole batches. A
 * client asks for one range after the other until its wait is over. {@link RoundPlanner} tells the rest.
 *
 * <pre>{@code
 * RoundPlanner planner = new RoundPlanner();
 * planner.beginRound(now(), 2000);
 * while (!planner.isOver(now(), decoder.batches() > 0)) {
 *     BatchRequest request = planner.next(now(), decoder.index(), decoder.received());
 *     if (request == null) break;
 *     planner.sent(now());
 *     for (byte[] portion : fetch(request.fromByte(), request.endByte())) {
 *         planner.arrived(now(), portion.length);
 *         decoder.feed(portion, 0, portion.length);
 *     }
 *     planner.ended(false);
 * }
 * }</pre>
 */
package org.jsmesh.plan;

package org.jsmesh.load;

/**
 * The server at both ends of a run, and what it did between, all of its starts together.
 *
 * @param before when it had started
 * @param after when everybody had left
 * @param cpuSeconds used, without starting
 * @param sentBytes of bodies as it counts them; NaN when it does not tell
 * @param output of the last start
 */
record ServerFigures(ProcessFigures before, ProcessFigures after, double cpuSeconds, double sentBytes, String output) {}

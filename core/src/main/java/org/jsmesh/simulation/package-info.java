/**
 * Simulated clients and links in virtual time. They show what a planner of batches brings, without a network and
 * without waiting.
 */
package org.jsmesh.simulation;

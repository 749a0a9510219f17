/**
 * Clients on links that do not exist, in virtual time: what a planner of batches brings, without a network and without
 * waiting.
 */
package org.jsmesh.simulation;

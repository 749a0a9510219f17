/**
 * Chooses, tests and performs half-edge collapses by a given cost, level by level, and logs the patches that undo them.
 */
package org.jsmesh.collapse;

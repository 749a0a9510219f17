/** Chooses, tests and performs half-edge collapses by a given cost, in passes, and logs the patches that undo them. */
package org.jsmesh.collapse;

/** Levels of simplification: thresholds of cost that grow from level to level. */
package org.jsmesh.level;

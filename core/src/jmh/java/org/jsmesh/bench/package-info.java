/** What the benchmarks share. */
package org.jsmesh.bench;

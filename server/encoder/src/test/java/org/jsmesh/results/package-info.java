/** Measures what the codec reaches, and compares it with what is recorded. */
package org.jsmesh.results;

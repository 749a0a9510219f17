/** Figures that are recorded in the repository, so that they do not get worse unnoticed. */
package org.jsmesh.test.results;

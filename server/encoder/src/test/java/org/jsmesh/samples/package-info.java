/**
 * Generators of the sample models in {@code models/}: deterministic, so that what is committed can be made again byte
 * for byte.
 */
package org.jsmesh.samples;

/**
 * What an archive says of itself: opening, header, index of batches. They are read and written by
 * {@link org.jsmesh.decode} and {@link org.jsmesh.encode}.
 */
package org.jsmesh.archive;

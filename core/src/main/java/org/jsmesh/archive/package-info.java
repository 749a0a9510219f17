/**
 * What an archive says of itself: opening, header, index of batches. They are read and written by
 * {@link org.jsmesh.decode} and {@link org.jsmesh.encode}.
 *
 * <pre>{@code
 * BatchIndex index = decoder.index();
 * for (int batch = 0; batch < index.size(); batch++)
 *     System.out.println(index.kind(batch) + " to byte " + index.end(batch) + ": " + index.faces(batch) + " faces");
 * }</pre>
 */
package org.jsmesh.archive;

/**
 * Archive in, mesh out, while bytes arrive.
 *
 * <pre>{@code
 * ArchiveDecoder chair = new ArchiveDecoder();
 * try (InputStream in = Files.newInputStream(Path.of("chair.jsm"))) {
 *     byte[] portion = new byte[4096];
 *     for (int n; (n = in.read(portion)) >= 0; ) {
 *         chair.feed(portion, 0, n);
 *         System.out.println(chair.batches() + " batches: " + chair.faces() + " faces");
 *     }
 * }
 * Mesh original = chair.meshInOrder();
 * }</pre>
 */
package org.jsmesh.decode;

/**
 * The poster of a model: one small picture, drawn by the processor alone when the model is encoded, as the page shows
 * the model at first. The same model gives the same bytes on every platform.
 *
 * <pre>{@code
 * Mesh chair = ModelFiles.read(Path.of("chair.glb")).mesh();
 * byte[] jpeg = Poster.jpeg(chair, UpAxis.Y, ModelPictures.of(chair));
 * Files.write(Path.of("chair.jpg"), jpeg);
 * }</pre>
 */
package org.jsmesh.poster;

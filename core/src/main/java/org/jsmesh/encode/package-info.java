/**
 * Mesh in, archive out: runs the simplification, codes its passes and indexes the batches. Model files are encoded by
 * {@code ModelEncoding} of the encoder module.
 *
 * <pre>{@code
 * EncoderSettings settings = EncoderSettings.defaults().withQuality(Quality.BEST);
 * EncodedArchive archive = new MeshEncoder(settings).encode(mesh, ProgressListener.NONE);
 * Files.write(Path.of("mesh.jsm"), archive.bytes());
 * }</pre>
 */
package org.jsmesh.encode;

/**
 * Many model files in, archives and a report out: reading and writing of model files, encoding in parallel, what an
 * archive holds as JSON.
 *
 * <pre>{@code
 * ModelEncoding encoding = new ModelEncoding(EncoderSettings.defaults().withThreads(4));
 * encoding.write(Path.of("chair.obj"), Path.of("chair.jsm"), ProgressListener.NONE);
 * Mesh chair = ArchiveFile.read(Path.of("chair.jsm")).original(ProgressListener.NONE);
 * ModelFiles.write(chair, Path.of("chair.glb"), ModelFormat.GLB);
 * }</pre>
 */
package org.jsmesh.files;

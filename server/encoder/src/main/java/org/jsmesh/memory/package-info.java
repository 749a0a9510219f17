/**
 * The memory that encoding takes: told before work begins, and shared by models that are encoded at the same time.
 *
 * <pre>{@code
 * EncoderSettings settings = EncoderSettings.defaults();
 * MemoryAdmission gate = MemoryAdmission.ofHeap();
 * MemoryEstimate need = MemoryEstimate.of(Path.of("chair.ply"), settings);
 * MemoryAdmission.Admission room = gate.admit(need.bytes());
 * try {
 *     new ModelEncoding(settings).write(Path.of("chair.ply"), Path.of("chair.jsm"), ProgressListener.NONE);
 * } finally {
 *     room.close();
 * }
 * }</pre>
 */
package org.jsmesh.memory;

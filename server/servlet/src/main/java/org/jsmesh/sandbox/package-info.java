/**
 * Encodes model files for a server, in a process of its own with limited memory and time, so that no model can harm the
 * server:
 *
 * <pre>{@code
 * SandboxLimits limits = SandboxLimits.defaults().withHeapMegabytes(2048).withMostFaces(5_000_000);
 * ModelEncoder encoder = SandboxEncoder.of(limits);
 * ModelStore store = new ModelStore(StoreSettings.of(Path.of("/srv/models")), encoder);
 * }</pre>
 */
package org.jsmesh.sandbox;

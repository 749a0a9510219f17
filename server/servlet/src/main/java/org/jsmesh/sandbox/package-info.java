/**
 * Encodes model files for a server, in a process of its own with limited memory and time, so that no model can harm the
 * server:
 *
 * <pre>{@code
 * ModelEncoder encoder = SandboxEncoder.of(SandboxLimits.defaults());
 * ModelStore store = new ModelStore(StoreSettings.of(Path.of("/srv/models")), encoder);
 * }</pre>
 */
package org.jsmesh.sandbox;

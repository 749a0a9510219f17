/**
 * The models of a folder as archives: found by id, encoded on first demand, kept in a cache folder, and sent with a
 * check of every block.
 *
 * <pre>{@code
 * ModelEncoder encoder = SandboxEncoder.of(SandboxLimits.defaults());
 * try (ModelStore store = new ModelStore(StoreSettings.of(Path.of("/srv/models")), encoder)) {
 *     ModelEntry chair = store.find("chair").orElseThrow();
 *     Archive archive = store.archive(chair).join();
 *     System.out.println(archive.bytes() + " bytes, SHA-256 " + archive.sha256());
 * }
 * }</pre>
 */
package org.jsmesh.store;

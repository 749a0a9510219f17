/**
 * Models that clients send: received into a spool folder, encoded one after the other by processes of their own, and
 * made visible whole. {@code application} is a {@code ServletContext} that is being initialized:
 *
 * <pre>{@code
 * ModelEncoder encoder = SandboxEncoder.of(SandboxLimits.defaults());
 * ModelStore store = new ModelStore(StoreSettings.of(Path.of("/srv/models")), encoder);
 * UploadTokens tokens = UploadTokens.read(Path.of("/etc/jsm/tokens"));
 * store.acceptUploads(UploadSettings.of(tokens).withMostFaces(1_000_000));
 * new StreamingServlet(store, ServletSettings.defaults()).mount(application, "/models/*");
 * }</pre>
 */
package org.jsmesh.upload;

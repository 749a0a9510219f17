/**
 * Secrets that the owner of a server keeps in files: they are read anew when the file changes, and the keys among them
 * sign addresses. {@code application} is a {@code ServletContext} that is being initialized:
 *
 * <pre>{@code
 * SignKeys keys = SignKeys.read(Path.of("/etc/jsm/sign-keys"));
 * StoreSettings models = StoreSettings.of(Path.of("/srv/models"));
 * new StreamingServlet(models, ServletSettings.defaults().withSignKeys(keys)).mount(application, "/models/*");
 * String query = keys.query("chair", Instant.now().plusSeconds(600));
 * System.out.println("https://meshes.example.org/models/chair/manifest.json?" + query);
 * }</pre>
 */
package org.jsmesh.secret;

/**
 * The models of a site that lies in a store of objects, such as a bucket, read on demand.
 *
 * <pre>{@code
 * try (ObjectStore objects = ObjectStores.open("s3://bucket/prefix", SiteStore.PATIENCE);
 *         SiteStore models = SiteStore.open(objects, SiteSettings.defaults())) {
 *     new StreamingServlet(models, ServletSettings.defaults()).mount(application, "/models/*");
 * }
 * }</pre>
 */
package org.jsmesh.store.bucket;

/**
 * Objects by key, in a folder or in a bucket: what sites and catalogues of models are read from and written to.
 *
 * <pre>{@code
 * try (ObjectStore store = ObjectStores.open("s3://models/site")) {
 *     store.list("m/", "", object -> {
 *         System.out.println(object.key() + ": " + object.bytes() + " bytes");
 *         return true;
 *     });
 * }
 * }</pre>
 */
package org.jsmesh.objects;

/**
 * Objects by key, in a folder or in a bucket: what sites and catalogues of models are read from and written to.
 *
 * <pre>{@code
 * try (ObjectStore store = ObjectStores.open("s3://models/site")) {
 *     store.put(Upload.of("m/chair/annotations.json", ObjectContent.of(bytes)).withCondition(Condition.ABSENT));
 * }
 * }</pre>
 */
package org.jsmesh.objects;

/**
 * A folder that any static host can serve: archives, manifests and catalogue under the servlet's addresses, and the
 * page. {@code page} holds the files of a page by their paths, {@code index.html} among them:
 *
 * <pre>{@code
 * try (StaticSite site = StaticSite.open(Path.of("public"), page)) {
 *     EncodeJob chair = new EncodeJob(Path.of("chair.obj"), site.staging().resolve("chair.jsm"));
 *     new ModelEncoding(EncoderSettings.defaults()).write(chair.input(), chair.output(), ProgressListener.NONE);
 *     site.publish(site.ids(List.of(chair)).get(0), chair);
 *     site.finish();
 * }
 * }</pre>
 */
package org.jsmesh.site;

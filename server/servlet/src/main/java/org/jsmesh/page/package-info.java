/**
 * The page of one model: what a browser shows before a script runs, and what links to it show. {@code page} holds the
 * files of a page by their paths:
 *
 * <pre>{@code
 * PageTemplate template = new PageTemplate(new String(page.get("index.html")), Map.of());
 * byte[] poster = Poster.jpeg(mesh, UpAxis.Y, List.of());
 * String html = template.page("chair", "{\"id\":\"chair\",\"name\":\"Chair\"}", poster, "https://example.org/");
 * }</pre>
 */
package org.jsmesh.page;

/**
 * The streaming client without a user interface: opens an archive, measures, plans, decodes as bytes arrive, resumes
 * and proves the original.
 *
 * <pre>{@code
 * URI chair = URI.create("https://example.org/m/chair/manifest.json");
 * try (StreamingSession session =
 *         StreamingSession.open(chair, SessionOptions.defaults(), SessionListener.NONE, Runnable::run)) {
 *     session.refine(2000).join();
 *     Mesh coarse = session.snapshot().join();
 *     SessionResult all = session.complete().join();
 *     System.out.println(coarse.faces() + " of " + all.mesh().faces() + " faces; identical: " + all.identical());
 * }
 * }</pre>
 */
package org.jsmesh.session;

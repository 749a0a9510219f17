/**
 * The streaming client without a face: opens an archive, measures, plans, decodes as bytes arrive, resumes and proves
 * the original.
 */
package org.jsmesh.session;

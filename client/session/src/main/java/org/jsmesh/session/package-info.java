/**
 * The streaming client without a user interface: opens an archive, measures, plans, decodes as bytes arrive, resumes
 * and proves the original.
 */
package org.jsmesh.session;

/** Servers and links for tests, shared with other modules as a test jar. */
package org.jsmesh.session.testing;

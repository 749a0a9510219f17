/** A real browser for tests. */
package org.jsmesh.web.testing;

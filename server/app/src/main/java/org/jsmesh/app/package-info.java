/** The {@code jsm} command and its embedded server. */
package org.jsmesh.app;

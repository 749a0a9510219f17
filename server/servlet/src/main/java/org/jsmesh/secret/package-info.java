/**
 * Secrets that the owner of a server keeps in files: they are read anew when the file changes, and the keys among them
 * sign addresses.
 */
package org.jsmesh.secret;

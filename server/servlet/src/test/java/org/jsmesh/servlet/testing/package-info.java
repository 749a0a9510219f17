/** Containers and clients for tests of this module and of the web application. */
package org.jsmesh.servlet.testing;

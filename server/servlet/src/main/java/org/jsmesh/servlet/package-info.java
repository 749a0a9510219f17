/**
 * The HTTP resources of the streaming protocol, under a path that the host chooses, for any container of Jakarta
 * Servlet 6.1.
 */
package org.jsmesh.servlet;

/** The HTTP resources of the streaming protocol and the files of the page, for any container of Jakarta Servlet 6.1. */
package org.jsmesh.servlet;

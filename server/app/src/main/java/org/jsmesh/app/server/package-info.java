/** The embedded server: Jetty, its limits, access log, metrics and management port. */
package org.jsmesh.app.server;

/** Connections of many viewers on one thread, each over a link of its own rate. */
package org.jsmesh.load.net;

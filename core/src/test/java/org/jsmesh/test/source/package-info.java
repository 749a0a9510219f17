/** Java sources in documents: found, compiled and run. */
package org.jsmesh.test.source;

/** What {@code docs/library.md} and the overviews of packages show, compiled and run. */
package org.jsmesh.library;

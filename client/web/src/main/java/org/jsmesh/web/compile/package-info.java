/**
 * What TeaVM leaves out, and what it takes another way, when it compiles the decoders. Part of the build; no jar has
 * it.
 */
package org.jsmesh.web.compile;

/** What TeaVM leaves out when it compiles the decoders. Part of the build; no jar has it. */
package org.jsmesh.web.compile;

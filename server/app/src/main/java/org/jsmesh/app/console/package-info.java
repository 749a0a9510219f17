/** What commands say: reports, progress and failures. */
package org.jsmesh.app.console;

/** How much heap a command needs, and starting the command again with so much. */
package org.jsmesh.app.heap;

/** What {@code jsm bench} measures. */
package org.jsmesh.app.bench;

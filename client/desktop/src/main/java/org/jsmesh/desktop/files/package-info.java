/** What the viewer opens and remembers: addresses, model files, and the settings of its user. */
package org.jsmesh.desktop.files;

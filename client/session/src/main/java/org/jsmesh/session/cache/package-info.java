/** First bytes of archives on disk, kept by sessions for later ones. Nothing outside of this module uses it. */
package org.jsmesh.session.cache;

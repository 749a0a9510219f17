/** Links of limited rate and some delay on this machine, to try and measure clients with. */
package org.jsmesh.session.link;

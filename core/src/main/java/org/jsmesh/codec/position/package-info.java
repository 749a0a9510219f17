/** Positions: predicted from the ring or a mirror image, coded as residuals, refined to more bits. */
package org.jsmesh.codec.position;

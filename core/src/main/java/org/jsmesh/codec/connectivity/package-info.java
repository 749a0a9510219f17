/** The connectivity of base meshes, components and vertex splits. */
package org.jsmesh.codec.connectivity;

/** Base meshes and vertex splits as connectivity: which ring a new vertex gets, which faces open. */
package org.jsmesh.codec.connectivity;

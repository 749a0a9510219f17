/** What a half-edge collapse costs. */
package org.jsmesh.weight;

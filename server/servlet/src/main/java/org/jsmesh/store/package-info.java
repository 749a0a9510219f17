/**
 * The models of a folder as archives: found by id, encoded on first demand, kept in a cache folder and mapped into
 * memory.
 */
package org.jsmesh.store;

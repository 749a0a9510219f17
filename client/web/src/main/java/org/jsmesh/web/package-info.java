/**
 * The decoder for the browser: compiled to WebAssembly and JavaScript, called from a worker, with arrays ready to draw.
 */
package org.jsmesh.web;

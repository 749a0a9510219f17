/**
 * The decoder as the browser sees it: compiled to WebAssembly and JavaScript, called from a worker, with arrays ready
 * to be drawn.
 */
package org.jsmesh.web;

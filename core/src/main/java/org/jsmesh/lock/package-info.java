/**
 * Files that one program at a time has locked. The one package of core that touches files, and only its users do so
 * through it: nothing else of core knows it, and the browser does not get it.
 */
package org.jsmesh.lock;

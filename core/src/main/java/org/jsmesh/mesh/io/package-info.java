/** Reads and writes PLY, OBJ + MTL, STL, OFF and Hoppe's .m; bytes in, bytes out, no file is opened here. */
package org.jsmesh.mesh.io;

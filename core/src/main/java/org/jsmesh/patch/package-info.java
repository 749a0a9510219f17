/** One patch, the data of one vertex split, and applying it. */
package org.jsmesh.patch;

/** The bytes of opening, header, index and payloads, in both directions, with their checksums. */
package org.jsmesh.archive.coding;

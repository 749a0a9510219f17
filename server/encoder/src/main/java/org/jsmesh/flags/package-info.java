/** What commands that encode have in common on their lines, written for picocli, which they bring along. */
package org.jsmesh.flags;

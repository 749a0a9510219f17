/** Archives of encoded models, kept in a folder of a limited size under what they were encoded from. */
package org.jsmesh.store.cache;

/**
 * Models that clients send: received into a spool folder, encoded one after the other by processes of their own, and
 * made visible whole.
 */
package org.jsmesh.upload;

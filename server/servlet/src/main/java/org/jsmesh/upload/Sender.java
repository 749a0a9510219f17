package org.jsmesh.upload;

/**
 * One who may send models, and how much the server keeps for them.
 *
 * @param key hash of the token, by which the server remembers whose models are whose
 * @param mostBytes of the archives that are kept for the token together
 * @param mostModels that are kept for the token, or wait to be encoded
 */
public record Sender(String key, long mostBytes, int mostModels) {}

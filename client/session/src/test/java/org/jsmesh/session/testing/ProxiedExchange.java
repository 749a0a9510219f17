package org.jsmesh.session.testing;

/**
 * One request through a {@link ShapingProxy}.
 *
 * @param connection counted from 0
 * @param method of the request
 * @param target path and query
 * @param range value of the Range header, or null
 * @param ifRange value of the If-Range header, or null
 * @param status of the answer; 0 when none came
 * @param fromByte first byte of the answer's body within the file: from its Content-Range, else 0
 * @param bodyBytes of the answer that were passed on
 */
public record ProxiedExchange(
        int connection,
        String method,
        String target,
        String range,
        String ifRange,
        int status,
        long fromByte,
        long bodyBytes) {}

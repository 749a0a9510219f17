package org.jsmesh.web;

/** A method of {@link DecoderMain} was called too early, or with an argument out of its range. */
final class WrongCallException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    WrongCallException(String message) {
        super(message);
    }
}

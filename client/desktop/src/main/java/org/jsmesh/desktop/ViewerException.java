package org.jsmesh.desktop;

/** The viewer cannot do what the user asked for; the message says what, where and the remedy. */
final class ViewerException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    ViewerException(String message) {
        super(message);
    }

    ViewerException(String message, Throwable cause) {
        super(message, cause);
    }
}

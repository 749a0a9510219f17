package org.jsmesh.spark;

/** Why a run ends before its work is done, with place, reason and remedy in the message. */
final class CatalogueException extends Exception {
    private static final long serialVersionUID = 1;

    CatalogueException(String message) {
        super(message);
    }

    CatalogueException(String message, Throwable cause) {
        super(message, cause);
    }
}

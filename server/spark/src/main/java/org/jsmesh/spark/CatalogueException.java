package org.jsmesh.spark;

import java.io.IOException;
import org.jsmesh.files.Explanation;

/** Why a run ends before its work is done, with place, reason and remedy in the message. */
final class CatalogueException extends Exception {
    private static final long serialVersionUID = 1;

    CatalogueException(String message) {
        super(message);
    }

    CatalogueException(String message, Throwable cause) {
        super(message, cause);
    }

    /**
     * Words for work in executors that could not go on.
     *
     * @param about address for failures that name none
     * @param failure from Spark, with what failed at its root where that is known
     */
    static CatalogueException brokenOff(String about, Throwable failure) {
        Throwable root = failure;
        for (Throwable e = failure; e != null; e = e.getCause()) if (e instanceof IOException) root = e;
        String reason = root instanceof IOException
                ? Explanation.of(about, root).toString()
                : about + ": " + firstLine(root) + ".";
        return new CatalogueException(
                "the run was broken off: " + reason + " When that is mended, run again: it goes on from here", failure);
    }

    /** {@return words for a cluster, or a connection to one, that could not be had} */
    static CatalogueException notBegun(Throwable failure) {
        return new CatalogueException(
                "Spark did not begin: " + firstLine(failure)
                        + ". Correct the options of spark-submit, such as --master",
                failure);
    }

    private static String firstLine(Throwable e) {
        String text = e.getMessage() == null ? e.toString() : e.getMessage();
        return text.strip().lines().findFirst().orElse("").replaceFirst("\\.$", "");
    }
}

package org.jsmesh.spark;

import java.io.Serializable;

/**
 * What is to be done about a model.
 *
 * @param kind of work
 * @param planned for {@link Kind#ENCODE}
 * @param row for {@link Kind#REFUSED} the row of the report; for {@link Kind#ABSENT} and {@link Kind#FORGOTTEN} the one
 *     that the last run wrote; for others null
 */
record PlanRow(Kind kind, PlannedModel planned, Row row) implements Serializable {
    private static final long serialVersionUID = 1;

    /** What there is to do. */
    enum Kind {
        /** It is new, or has changed. */
        ENCODE,
        /** It is as it was. */
        KEPT,
        /** It failed, and is as it was. */
        KEPT_FAILURE,
        /** It cannot be encoded, which is known before it is tried. */
        REFUSED,
        /** An earlier run published it, and it is not among the inputs any more. */
        ABSENT,
        /** An earlier run could not encode it, and it is not among the inputs any more. */
        FORGOTTEN
    }

    boolean is(Kind other) {
        return kind == other;
    }
}

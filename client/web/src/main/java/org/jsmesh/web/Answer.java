package org.jsmesh.web;

import org.jsmesh.mesh.MalformedStreamException;

/**
 * What a method of {@link DecoderMain} answers: JSON text of one of two shapes, so that no exception has to cross from
 * Java to JavaScript.
 *
 * <pre>
 *     {"value": …}
 *     {"error": {"kind": "damaged", "message": "…"}}
 * </pre>
 */
final class Answer {
    /** The bytes are no archive, or the decoder stumbled over them. */
    static final String DAMAGED = "damaged";
    /** A call in the wrong order or with an argument out of its range: a fault of the caller. */
    static final String CALL = "call";
    /** The model needs more memory than there is. */
    static final String MEMORY = "memory";

    /** Computes a value and writes it. */
    interface Work {
        void write(Json json) throws MalformedStreamException;
    }

    private Answer() {}

    /** The value that the work writes, or the error that stopped it. */
    static String of(Work work) {
        try {
            Json json = new Json().open('{').key("value");
            work.write(json);
            return json.close('}').toString();
        } catch (WrongCallException e) {
            return error(CALL, e.getMessage());
        } catch (OutOfMemoryError e) {
            return error(MEMORY, "there is not enough memory for this model");
        } catch (Throwable e) { // a caller in another language can catch nothing
            return error(DAMAGED, e.getMessage() == null ? "the decoder stopped" : e.getMessage());
        }
    }

    /** The answer of a method that gives nothing back. */
    static String done(Runnable work) {
        return of(json -> {
            work.run();
            json.text(null);
        });
    }

    private static String error(String kind, String message) {
        Json json = new Json().open('{').key("error").open('{');
        json.key("kind").text(kind).key("message").text(message);
        return json.close('}').close('}').toString();
    }
}

package org.jsmesh.simulation;

/** The version of HTTP. It decides what giving up a response costs, and how many bytes the head of a response has. */
public enum HttpVersion {
    /** The connection is closed: what is on its way is lost, and the next request opens another. */
    HTTP_1_1("h1", 300),
    /** The stream is reset: what the server has handed to its kernel still crosses, in front of the next response. */
    HTTP_2("h2", 60);

    private final String label;
    final int headBytes;

    HttpVersion(String label, int headBytes) {
        this.label = label;
        this.headBytes = headBytes;
    }

    /** {@return the short name, as tables show it: h1 or h2} */
    public String label() {
        return label;
    }
}

package org.jsmesh.app.paper;

import java.io.IOException;
import java.net.URI;

/** The two servers behind a link of a rate that can be changed. */
interface Wire extends AutoCloseable {
    /** The link from now on. */
    void shape(LinkKind link) throws IOException;

    /** As fast as this machine is, from now on. */
    void open() throws IOException;

    /** Address of the server of archives, over the link. */
    URI archives();

    /** Address of the server of text, over the link. */
    URI text();

    /** Bytes that the servers have sent over the link, with all heads. */
    long carriedBytes() throws IOException;

    /** How the link is shaped, a clause. */
    String described();

    @Override
    void close() throws IOException;
}

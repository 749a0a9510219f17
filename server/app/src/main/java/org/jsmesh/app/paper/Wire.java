package org.jsmesh.app.paper;

import java.io.IOException;
import java.net.URI;
import java.util.List;
import java.util.stream.Collectors;

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

    /** Bytes that the servers have sent over the link, with the heads of their answers. */
    long carriedBytes() throws IOException;

    /** Whether a round trip takes the time that the link has for it. */
    boolean hasRoundTrips();

    /** How the link is shaped, a clause. */
    String described();

    /** Links, and how they are shaped, as it follows upon "over". */
    default String described(List<LinkKind> links) {
        return links.stream()
                        .map(link -> hasRoundTrips() ? link.described() : link.name())
                        .collect(Collectors.joining("; "))
                + ": " + described();
    }

    @Override
    void close() throws IOException;
}

package org.jsmesh.app.paper;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.URI;
import java.util.List;
import org.junit.jupiter.api.Test;

class WireTest {
    private static final List<LinkKind> LINKS =
            List.of(new LinkKind("10 Mbit/s", 10e6, 1), new LinkKind("64 kbit/s", 64e3, 100));

    @Test
    void shouldTellTheRoundTripsThatItKeepsTo() {
        assertThat(new Described(true).described(LINKS))
                .isEqualTo("10 Mbit/s with 1 ms from end to end and back; "
                        + "64 kbit/s with 100 ms from end to end and back: as it is");
    }

    @Test
    void shouldTellNoRoundTripsThatItLacks() {
        assertThat(new Described(false).described(LINKS)).isEqualTo("10 Mbit/s; 64 kbit/s: as it is");
    }

    /** Carries nothing. */
    private record Described(boolean hasRoundTrips) implements Wire {
        @Override
        public void shape(LinkKind link) {}

        @Override
        public void open() {}

        @Override
        public URI archives() {
            return URI.create("http://127.0.0.1/");
        }

        @Override
        public URI text() {
            return URI.create("http://127.0.0.1/");
        }

        @Override
        public long carriedBytes() {
            return 0;
        }

        @Override
        public String described() {
            return "as it is";
        }

        @Override
        public void close() {}
    }
}

package org.jsmesh.session.testing;

import java.util.ArrayList;
import java.util.List;

/** The requests that passed a proxy, in the order in which they came. Thread-safe. */
final class ExchangeLog {
    private final List<ProxiedExchange> exchanges = new ArrayList<>();

    /** Notes a request. Returns its number. */
    synchronized int begin(int connection, HttpHeadReader head) {
        exchanges.add(new ProxiedExchange(
                connection, head.word(0), head.word(1), head.field("range"), head.field("if-range"), 0, 0, 0));
        return exchanges.size() - 1;
    }

    synchronized ProxiedExchange get(int exchange) {
        return exchanges.get(exchange);
    }

    synchronized List<ProxiedExchange> list() {
        return List.copyOf(exchanges);
    }

    synchronized void answered(int exchange, int status, long fromByte) {
        ProxiedExchange e = exchanges.get(exchange);
        exchanges.set(
                exchange,
                new ProxiedExchange(
                        e.connection(), e.method(), e.target(), e.range(), e.ifRange(), status, fromByte, 0));
    }

    synchronized void passed(int exchange, int bytes) {
        ProxiedExchange e = exchanges.get(exchange);
        exchanges.set(
                exchange,
                new ProxiedExchange(
                        e.connection(),
                        e.method(),
                        e.target(),
                        e.range(),
                        e.ifRange(),
                        e.status(),
                        e.fromByte(),
                        e.bodyBytes() + bytes));
    }
}

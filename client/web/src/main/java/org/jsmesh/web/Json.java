package org.jsmesh.web;

/** Writes JSON text; numbers that JSON lacks become null. */
final class Json {
    private static final String DIGITS = "0123456789abcdef";

    private final StringBuilder out = new StringBuilder();
    private boolean first = true;

    Json open(char bracket) {
        separate();
        out.append(bracket);
        first = true;
        return this;
    }

    Json close(char bracket) {
        out.append(bracket);
        first = false;
        return this;
    }

    Json key(String name) {
        text(name);
        out.append(':');
        first = true;
        return this;
    }

    Json text(String value) {
        separate();
        if (value == null) out.append("null");
        else quote(value);
        return this;
    }

    Json number(double value) {
        separate();
        if (value == (long) value && Math.abs(value) < 0x1p63) out.append((long) value);
        else if (Double.isFinite(value)) ExactDecimal.append(out, value);
        else out.append("null");
        return this;
    }

    Json flag(boolean value) {
        separate();
        out.append(value);
        return this;
    }

    @Override
    public String toString() {
        return out.toString();
    }

    private void separate() {
        if (!first) out.append(',');
        first = false;
    }

    private void quote(String value) {
        out.append('"');
        for (int i = 0; i < value.length(); i++) {
            char c = value.charAt(i);
            if (c == '"' || c == '\\') out.append('\\').append(c);
            else if (c >= ' ') out.append(c);
            else out.append("\\u00").append(DIGITS.charAt(c >> 4)).append(DIGITS.charAt(c & 15));
        }
        out.append('"');
    }
}

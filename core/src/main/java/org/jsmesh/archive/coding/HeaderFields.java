package org.jsmesh.archive.coding;

import org.jsmesh.codec.entropy.BinaryCoder;
import org.jsmesh.codec.entropy.IntegerModel;
import org.jsmesh.codec.entropy.TextModel;
import org.jsmesh.mesh.MalformedStreamException;

/** The kinds of values that a header is made of, in both directions. Statistics go on from the opening to the rest. */
final class HeaderFields {
    final IntegerModel counts = new IntegerModel(1);
    final TextModel texts = new TextModel();
    private BinaryCoder coder;

    /** Goes on with another stream. */
    void on(BinaryCoder stream) {
        coder = stream;
    }

    void checkEnd() throws MalformedStreamException {
        if (coder.isExhausted()) throw new MalformedStreamException(-1, "the header ends early");
    }

    int count(int value, int most) throws MalformedStreamException {
        int n = counts.unsigned(coder, value);
        if (n < 0 || n > most) throw new MalformedStreamException(-1, "a count of the header is " + n);
        return n;
    }

    String text(String value) throws MalformedStreamException {
        return texts.code(coder, value);
    }

    float number(float value) throws MalformedStreamException {
        float x = Float.intBitsToFloat(coder.raw(Float.floatToRawIntBits(value), 32));
        if (Float.isNaN(x) || Float.isInfinite(x))
            throw new MalformedStreamException(-1, "a number of the header is not finite");
        return x;
    }

    boolean flag(boolean value) {
        return coder.raw(value ? 1 : 0, 1) == 1;
    }
}

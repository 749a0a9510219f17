package org.jsmesh.web;

import org.teavm.jso.JSBody;

/** What decoders in JavaScript call in place of the class library: see {@code ScriptWays}. */
final class ScriptMath {
    private ScriptMath() {}

    /** In place of {@link Integer#numberOfLeadingZeros}, which TeaVM compiles to tests of its own. */
    static int leadingZeros(int x) {
        return clz32(x);
    }

    @JSBody(params = "x", script = "return Math.clz32(x);")
    private static native int clz32(int x);
}

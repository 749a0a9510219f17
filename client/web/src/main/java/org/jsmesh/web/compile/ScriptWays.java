package org.jsmesh.web.compile;

import java.util.Map;
import org.teavm.model.MethodReference;
import org.teavm.model.ValueType;

/** JavaScript has functions for which WebAssembly has instructions, and which TeaVM does not use. */
public final class ScriptWays extends BrowserWays {
    /** Makes the transformer; TeaVM does. */
    public ScriptWays() {
        super(Map.of(
                new MethodReference(Integer.class, "numberOfLeadingZeros", int.class, int.class),
                new MethodReference(
                        "org.jsmesh.web.ScriptMath", "leadingZeros", ValueType.INTEGER, ValueType.INTEGER)));
    }
}

package org.jsmesh.web.compile;

import java.util.List;

/** The whole decoder lacks what only an encoder calls. TeaVM reaches it because one code serves both directions. */
public final class WholeDecoderParts extends LeftOut {
    static final List<String> ENCODER = List.of("PatchPlan.*", "EncoderTruth.*", "SplitSteps.*", "RangeEncoder.*");

    /** Makes the transformer; TeaVM does. */
    public WholeDecoderParts() {
        super(ENCODER, List.of());
    }
}

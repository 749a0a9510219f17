package org.jsmesh.web.compile;

import java.util.List;
import java.util.stream.Stream;

/** The whole decoder lacks what only an encoder calls. TeaVM reaches it because one code serves both directions. */
public final class WholeDecoderParts extends LeftOut {
    static final List<String> ENCODER = List.of("PatchPlan.*", "EncoderTruth.*", "SplitSteps.*", "RangeEncoder.*");

    /** A decoder's truth of positions knows nothing, and does nothing. */
    static final List<String> TRUTH = Stream.of("want", "find", "renumber", "move", "haveMoved", "isMoved", "isMoving")
            .map(method -> "PositionTruth." + method)
            .toList();

    /** Makes the transformer; TeaVM does. */
    public WholeDecoderParts() {
        super(ENCODER, TRUTH);
    }
}

package org.jsmesh.web.compile;

import java.util.List;
import java.util.stream.Stream;

/**
 * The first decoder lacks what the base and the first splits of most models do not need. Where a model needs it sooner,
 * a method throws, and the page waits for the whole decoder.
 */
public final class FirstDecoderParts extends LeftOut {
    private static final List<String> FAILING = List.of(
            "RemainderCoder.read",
            "OrderCoder.read",
            "OriginalParts.finish",
            "DecodingSession.mesh",
            "LiveMesh.replace",
            "LodSnapshot.of",
            "SweepCoder.codeAttributes",
            "PreviewCoder.*",
            "MtlLook.uses",
            "LookKey.addUse");

    /** Images are passed over, and materials of other formats than glTF have colours alone. */
    private static final List<String> IDLE = List.of("OriginalParts.take", "PreviewStages.decode", "MtlLook.use");

    /** Makes the transformer; TeaVM does. */
    public FirstDecoderParts() {
        super(
                Stream.concat(WholeDecoderParts.ENCODER.stream(), FAILING.stream())
                        .toList(),
                Stream.concat(WholeDecoderParts.TRUTH.stream(), IDLE.stream()).toList());
    }
}

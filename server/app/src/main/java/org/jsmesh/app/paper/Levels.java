package org.jsmesh.app.paper;

import java.util.ArrayList;
import java.util.List;
import org.jsmesh.collapse.PaperSimplifier;

/**
 * Where a simplification of the paper's method ends: with the last threshold, or before, with the number of faces.
 *
 * @param thresholds ascending
 * @param faces at which it ends; 0 for none
 */
record Levels(List<Double> thresholds, int faces) {
    /** Those of {@code --simplifier paper}. */
    static final Levels USUAL = new Levels(PaperSimplifier.DEFAULT_THRESHOLDS, 0);

    private static final List<Double> BEYOND = List.of(.6, .8, 1., 1.5, 2.);

    static final String DESCRIBED = "The paper's method takes its thresholds " + PaperSimplifier.DEFAULT_THRESHOLDS
            + " here, and those of " + BEYOND + " behind them until the paper's share of the faces is left: that the"
            + " number of levels is the ending condition, and can be set, is section 4 of the paper, which names no"
            + " threshold.";

    /** To the share of the faces that the paper keeps, by larger thresholds where it takes them. */
    static Levels to(StandIn model) {
        List<Double> thresholds = new ArrayList<>(PaperSimplifier.DEFAULT_THRESHOLDS);
        thresholds.addAll(BEYOND);
        PaperModel.Counts counts = model.model().counts;
        double share = (double) counts.baseFaces() / counts.faces();
        return new Levels(thresholds, (int) Math.round(share * model.mesh().faces()));
    }
}

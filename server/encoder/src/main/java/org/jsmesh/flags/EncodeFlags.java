package org.jsmesh.flags;

import java.util.List;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.encode.Quality;
import org.jsmesh.encode.Simplifier;
import org.jsmesh.mesh.UpAxis;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;

/** The options that decide the bytes of archives. A mixin. */
public final class EncodeFlags {
    @Option(
            names = "--base-faces",
            paramLabel = "N",
            description = "Faces of the base mesh to aim at. Default: about the first 1%% of the bytes.")
    private int baseFaces;

    @Option(
            names = "--simplifier",
            paramLabel = "quadric|paper",
            converter = EncodeConverters.SimplifierName.class,
            description = {
                "quadric (default): the least distance to the original at any number of faces.",
                "paper: the method of Chen and Nishita 2002. It removes no vertex at a crease, a boundary, or a change of material or attributes, and shows exact positions from the start."
            })
    private Simplifier simplifier = Simplifier.QUADRIC;

    @Option(
            names = "--quality",
            paramLabel = "fast|default|best",
            converter = EncodeConverters.QualityName.class,
            description = {
                "For --simplifier quadric: how much time may go into the shape of the coarse levels.",
                "The whole model comes back bit for bit with any."
            })
    private Quality quality = Quality.DEFAULT;

    @Option(
            names = "--levels",
            paramLabel = "T",
            split = ",",
            converter = EncodeConverters.Threshold.class,
            description = {
                "For --simplifier paper: up to which difference between the normals (0 to 2) and other attributes at the ends of an edge it is removed, level by level, ascending.",
                "10 removes all that the method can. Default: .15,.3,.4"
            })
    private List<Double> levels = List.of();

    @Option(
            names = "--keep-order",
            description =
                    "Give back vertices, faces and corners in their order, and vertices and materials that no face uses. Costs bytes.")
    private boolean keepOrder;

    @Option(
            names = "--up",
            paramLabel = "y|z",
            converter = EncodeConverters.Axis.class,
            description = {
                "The axis of the models that points up; viewers turn them by it, coordinates stay as they are.",
                "Default: what the format says (glTF y, 3MF z), else unknown."
            })
    private UpAxis up = UpAxis.UNKNOWN;

    @Option(names = "--no-poster", description = "Put no poster (a small picture of the model) into the archives.")
    private boolean withoutPoster;

    /**
     * What was asked for.
     *
     * @param spec of the command, for the message
     * @return the settings, with the defaults for what has no option here
     * @throws ParameterException that says what does not go together
     */
    public EncoderSettings settings(CommandSpec spec) {
        if (baseFaces < 0)
            throw new ParameterException(
                    spec.commandLine(), "--base-faces is " + baseFaces + ", it cannot be negative");
        if (!levels.isEmpty() && simplifier != Simplifier.PAPER)
            throw new ParameterException(
                    spec.commandLine(), "--levels goes with --simplifier paper; quadric finds its own levels");
        if (quality != Quality.DEFAULT && simplifier == Simplifier.PAPER)
            throw new ParameterException(
                    spec.commandLine(),
                    "--quality goes with --simplifier quadric; the paper's method has one way only");
        try {
            return EncoderSettings.defaults()
                    .withBaseFaces(baseFaces)
                    .withKeepOrder(keepOrder)
                    .withSimplifier(simplifier)
                    .withQuality(quality)
                    .withLevels(levels)
                    .withUp(up)
                    .withPoster(!withoutPoster);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage(), e);
        }
    }
}

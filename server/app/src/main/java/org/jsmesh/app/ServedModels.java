package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.ObjectStores;
import org.jsmesh.store.ModelSource;
import org.jsmesh.store.bucket.SiteStore;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.ParameterException;

/** What {@code jsm serve} serves: a folder or file of models, or a site that lies in a bucket or a folder. */
final class ServedModels implements AutoCloseable {
    private final ModelSource models;
    private final ObjectStore objects; // null for a folder of models

    private ServedModels(ModelSource models, ObjectStore objects) {
        this.models = models;
        this.objects = objects;
    }

    /** Whether a text names a site that is written already, rather than models to encode. */
    static boolean isSite(String source) {
        if (ObjectStores.isRemote(source) || source.startsWith("file://")) return true;
        try {
            Path folder = Path.of(source);
            return Files.isRegularFile(folder.resolve("m/index.json"))
                    && Files.isRegularFile(folder.resolve("index.html"));
        } catch (InvalidPathException e) {
            return false;
        }
    }

    /** Opens a site. */
    static ServedModels site(String source, SiteOptions options) throws CommandFailure {
        ObjectStore objects;
        try {
            objects = ObjectStores.open(source, SiteStore.PATIENCE);
        } catch (IllegalArgumentException e) {
            throw new CommandFailure(e.getMessage() + ".");
        } catch (IOException e) {
            throw new CommandFailure(source, e);
        }
        try {
            return new ServedModels(SiteStore.open(objects, options.settings()), objects);
        } catch (IOException | RuntimeException e) {
            closeQuietly(objects);
            throw e instanceof IllegalArgumentException
                    ? new CommandFailure("--site-memory or --redirect-lifetime: " + e.getMessage() + ".")
                    : new CommandFailure(source, e);
        }
    }

    /** Models that the caller has opened. */
    static ServedModels of(ModelSource opened) {
        return new ServedModels(opened, null);
    }

    /**
     * Refuses options that mean nothing for what is served.
     *
     * @param mixins names of the fields that hold them
     */
    static void refuse(CommandSpec spec, Configuration configuration, List<String> mixins, String why) {
        for (String mixin : mixins) {
            for (OptionSpec option : spec.mixins().get(mixin).options()) refuse(spec, configuration, option, why);
        }
    }

    static void refuse(CommandSpec spec, Configuration configuration, OptionSpec option, String why) {
        boolean isFlag = spec.commandLine().getParseResult().hasMatchedOption(option);
        Configuration.Value set = configuration.find(Configuration.name(option));
        if (!isFlag && set == null) return;
        String where = isFlag ? "" : " (" + set.source() + ")";
        throw new ParameterException(spec.commandLine(), option.longestName() + where + " " + why + ". Leave it out");
    }

    ModelSource models() {
        return models;
    }

    @Override
    public void close() {
        models.close();
        if (objects != null) closeQuietly(objects);
    }

    private static void closeQuietly(ObjectStore objects) {
        try {
            objects.close();
        } catch (IOException e) {
            // It was read only: nothing can be lost.
        }
    }
}

package org.jsmesh.app;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.jsmesh.app.console.CommandFailure;
import org.jsmesh.app.console.JsonReport;
import org.jsmesh.app.console.Output;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.EncodeJob;
import org.jsmesh.files.EncodePlan;
import org.jsmesh.files.EncodeResult;
import org.jsmesh.files.Explanation;
import org.jsmesh.files.FolderEncoder;
import org.jsmesh.flags.EncodeFlags;
import org.jsmesh.flags.PublicUrl;
import org.jsmesh.mesh.Note;
import org.jsmesh.objects.ObjectStores;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code jsm encode}: model files in, archives out. */
@Command(
        name = "encode",
        description = {
            "Encodes model files (PLY, OBJ with MTL, STL, OFF, Hoppe .m, glTF as .glb or .gltf) as archives.",
            "A file that cannot be encoded is named and fails alone; the others are written."
        },
        footer = {
            "",
            "Examples:",
            "  jsm encode bunny.ply -o bunny.jsm",
            "  jsm encode models/ -o archives/",
            "  jsm encode cessna.m -o cessna.jsm --simplifier paper --levels .25,.5",
            "  jsm encode models/ --site public/"
        })
final class EncodeCommand implements Callable<Integer> {
    private static final Path UNWRITTEN = Path.of(".jsm-unwritten");

    @Spec
    private CommandSpec spec;

    @Parameters(
            arity = "0..*",
            paramLabel = "INPUT",
            description = "Model files, or folders whose model files are taken at any depth.")
    private List<Path> inputs = new ArrayList<>();

    @Option(
            names = {"-o", "--output"},
            paramLabel = "OUT",
            description = "The archive to write for one input file; else a folder, made when missing.")
    private String out;

    @Option(
            names = "--site",
            arity = "0..1",
            fallbackValue = "",
            paramLabel = "OUT",
            description = {
                "Make OUT a folder, or s3://bucket/prefix, that any static host can serve: archives, manifests, catalogue and viewer page.",
                "Archives (.jsm) among the INPUTs are taken as they are.",
                "Models that are in it already stay, or are replaced by those of the same name."
            })
    private String site;

    @Option(
            names = "--public-url",
            paramLabel = "URL",
            description =
                    "For --site: where visitors find the site. Those who show links to a model then find its picture.")
    private String publicUrl;

    @Option(names = "--prune", description = "For --site: take the models off the site that are not among the inputs.")
    private boolean prune;

    @Mixin
    private EncodeFlags flags;

    @Option(
            names = "--threads",
            paramLabel = "N",
            description = "Threads to use; the archives do not depend on it. Default: one per processor.")
    private int threads = Runtime.getRuntime().availableProcessors();

    @Mixin
    private HeapOptions heap;

    @Mixin
    private JsonReport json;

    @Mixin
    private Output output;

    @Override
    public Integer call() throws CommandFailure, InterruptedException {
        if (threads < 1)
            throw new ParameterException(spec.commandLine(), "--threads is " + threads + ", it must be at least 1");
        checkPlaces();
        EncoderSettings settings = flags.settings(spec).withThreads(threads);
        List<IOException> unreadable = new ArrayList<>();
        // Of a site only the inputs count here: where it is, is locked first.
        List<EncodeJob> planned = site == null ? jobs(unreadable) : plan(UNWRITTEN, new ArrayList<>());
        Integer code = heap.elsewhere(planned, settings, output);
        if (code != null) return code;
        List<EncodeResult> results;
        if (site == null) {
            results = encode(settings, planned);
        } else {
            try (SiteRun run = SiteRun.begin(out, PublicUrl.of(spec, publicUrl))) {
                List<EncodeJob> jobs = plan(run.staging(), unreadable);
                List<EncodeJob> models =
                        jobs.stream().filter(job -> !SiteRun.isArchive(job)).toList();
                List<EncodeResult> encoded = models.isEmpty() ? List.of() : encode(settings, models);
                // What could not be read may be in the site from an earlier run.
                results = run.publish(jobs, encoded, prune && unreadable.isEmpty());
                if (prune && !unreadable.isEmpty()) {
                    output.error(
                            "--prune takes nothing off the site, because some inputs cannot be read. Mend that first.");
                }
            }
        }
        if (json.isWanted()) output.json(results);
        boolean failed = !unreadable.isEmpty();
        for (IOException e : unreadable) output.error(Explanation.of(null, e).toString());
        for (EncodeResult result : results) {
            if (!json.isWanted()) report(result);
            if (result.isFailed()) output.error(result.error());
            failed |= result.isFailed();
        }
        return failed ? 1 : 0;
    }

    private List<EncodeResult> encode(EncoderSettings settings, List<EncodeJob> jobs) throws InterruptedException {
        try (EncodeProgress listener = new EncodeProgress(jobs, output)) {
            return new FolderEncoder(settings).encode(jobs, listener);
        }
    }

    /** Sorts out {@code --site OUT}, {@code --site -o OUT} and {@code --site INPUT -o OUT}. */
    private void checkPlaces() {
        if (site != null && !site.isEmpty()) {
            if (out == null) out = site;
            else inputs.add(0, Path.of(site));
        }
        if (inputs.isEmpty()) throw new ParameterException(spec.commandLine(), "Missing required parameter: 'INPUT'");
        if (out == null)
            throw new ParameterException(
                    spec.commandLine(), "Missing required option: '--output=OUT', or '--site OUT' for a site");
        if (out.isEmpty())
            throw new ParameterException(
                    spec.commandLine(),
                    "Invalid value for option '--output' (OUT): it is empty. Name a file or a folder");
        if (publicUrl != null && site == null)
            throw new ParameterException(spec.commandLine(), "--public-url goes with --site; archives have no address");
        if (prune && site == null)
            throw new ParameterException(spec.commandLine(), "--prune goes with --site; other outputs are left alone");
        if (site == null && ObjectStores.isRemote(out))
            throw new ParameterException(
                    spec.commandLine(),
                    "-o " + out + " is no file or folder. To write to a bucket, make a site: --site " + out);
    }

    private List<EncodeJob> jobs(List<IOException> unreadable) throws CommandFailure {
        boolean toFolder = inputs.size() > 1 || Files.isDirectory(inputs.get(0));
        if (toFolder && Files.exists(Path.of(out)) && !Files.isDirectory(Path.of(out))) {
            throw new ParameterException(
                    spec.commandLine(), "-o " + out + " is a file, but several archives need a folder");
        }
        if (toFolder) return plan(Path.of(out), unreadable);
        try {
            return EncodePlan.of(inputs.get(0), Path.of(out));
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage(), e);
        }
    }

    private List<EncodeJob> plan(Path folder, List<IOException> unreadable) throws CommandFailure {
        try {
            return EncodePlan.of(inputs, folder, unreadable::add);
        } catch (IllegalArgumentException e) {
            throw new ParameterException(spec.commandLine(), e.getMessage(), e);
        } catch (IOException e) {
            for (IOException before : unreadable)
                output.error(Explanation.of(null, before).toString());
            throw new CommandFailure(inputs.get(0), e);
        }
    }

    private void report(EncodeResult r) {
        if (r.isFailed()) return;
        for (Note note : r.notes()) output.note(r.input() + (note.warning() ? ": warning: " : ": ") + note.text());
        output.line(String.format(
                Locale.ROOT,
                "%s: %d faces, %d bytes in %d batches, base of %d faces, %.1f s -> %s",
                r.input(),
                r.faces(),
                r.bytes(),
                r.batches(),
                r.baseFaces(),
                r.encodeSeconds(),
                r.output()));
    }
}

package org.jsmesh.app;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.Arrays;
import java.util.Map;

/** Runs a command line in this process and keeps what it prints. */
public record Cli(int code, String out, String err) {
    public static Cli run(Object... args) {
        return with(System.getenv(), args);
    }

    /** The same with these variables as the environment. */
    static Cli with(Map<String, String> environment, Object... args) {
        StringWriter out = new StringWriter();
        StringWriter err = new StringWriter();
        String[] words = Arrays.stream(args).map(Object::toString).toArray(String[]::new);
        int code = Jsm.run(environment, new PrintWriter(out, true), new PrintWriter(err, true), words);
        return new Cli(code, out.toString(), err.toString());
    }

    /** The same for a command that must succeed. */
    public static Cli ok(Object... args) {
        Cli cli = run(args);
        if (cli.code != 0) throw new AssertionError(Arrays.toString(args) + ": exit " + cli.code + ": " + cli.err);
        return cli;
    }
}

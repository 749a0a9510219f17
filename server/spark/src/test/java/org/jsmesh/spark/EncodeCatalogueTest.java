package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jsmesh.app.Jsm;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;

class EncodeCatalogueTest {
    /** Options of the command that say how it prints, runs and names its outputs. */
    private static final Set<String> OTHER =
            Set.of("--threads", "--output", "--json", "--quiet", "--help", "--version", "--max-heap", "--no-relaunch");

    @Test
    void shouldHaveTheOptionsOfTheCommand() {
        StringWriter help = new StringWriter();
        PrintWriter out = new PrintWriter(help, true);
        Jsm.run(out, out, "encode", "--help");
        Set<String> ofTheCommand = options(help.toString());
        assertThat(ofTheCommand).contains("--quality=fast|default|best", "--prune");
        Set<String> here = options(new CommandLine(new EncodeCatalogue()).getUsageMessage());
        for (String option : ofTheCommand) {
            String name = option.replaceFirst("=.*", "");
            if (!OTHER.contains(name) && !name.equals("--site"))
                assertThat(here).contains(option);
        }
    }

    private static Set<String> options(String help) {
        Set<String> options = new TreeSet<>();
        Matcher option = Pattern.compile("(?m)^\\s+(?:-\\w, )?(--[\\w-]+(?:=[^\\s\\[]+)?)")
                .matcher(help);
        while (option.find()) options.add(option.group(1));
        return options;
    }

    @Test
    void shouldSayInOneLineWhySparkDoesNotBegin() {
        StringWriter err = new StringWriter();
        int code = new CommandLine(new EncodeCatalogue())
                .setErr(new PrintWriter(err, true))
                .execute("in", "--site", "out");
        assertThat(code).isEqualTo(2);
        // The second where tests before this one have left theirs.
        assertThat(err.toString())
                .matches("Spark did not begin: (A master URL must be set|Only one SparkContext should be running).*\\."
                        + " Correct the options of spark-submit, such as --master\\R");
        assertThat(new CommandLine(new EncodeCatalogue()).getCommandSpec().exitCodeOnExecutionException())
                .isEqualTo(2);
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = ';',
            value = {
                "--site out; Missing required parameter",
                "in; Missing required option",
                "in --site s3://public; Say with --report",
                "in --site s3://public/; Say with --report",
                "in --site s3://public//; Say with --report",
                "in --site s3://public --report s3://public/report; must not lie in each other",
                "in --site s3://public/models// --report s3://public/models; must not lie in each other",
                "in --site s3://public/models --report s3://public/models/x/y//; must not lie in each other",
                "in --site s3://public/models --report s3://public; must not lie in each other",
                "in --site out --report out/; must not lie in each other",
                "in --site out --report x/../out/report; must not lie in each other",
                "in --site x/out --report .; must not lie in each other",
                "in --site file://host/out; --site file://host/out: is no address of a file of this machine",
                "in --site out --quality good; is no quality",
                "in --site out --levels .2; --levels goes with --simplifier paper",
                "in --site out --base-faces -1; cannot be negative",
                "in --site out --public-url here; is no address",
                "in --site out --public-url https://x.org/?a; is no address"
            })
    void shouldSayWhatIsWrongWithTheLine(String line, String said) {
        StringWriter err = new StringWriter();
        int code = new CommandLine(new EncodeCatalogue())
                .setErr(new PrintWriter(err, true))
                .execute(line.split(" "));
        assertThat(code).isEqualTo(2);
        assertThat(err.toString()).contains(said);
    }
}

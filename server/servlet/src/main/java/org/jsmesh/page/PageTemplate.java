package org.jsmesh.page;

import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * A page that shows models, from which the pages of single models are made. It needs a title, a description, an
 * encoding ({@code <meta charset="utf-8">}) and a {@code noscript} element. It may name files that a model's page needs
 * at once, in {@code <meta name="jsm-model-files" content="PATH PATH">}. Its links must be relative, and hold in the
 * folder where it lies; the pages of models lie two folders deeper, at {@code m/{id}/}, and say where their links
 * begin. Immutable.
 *
 * @param html the page
 * @param headers of HTTP to send with the pages of models, such as {@code Content-Security-Policy}
 */
public record PageTemplate(String html, Map<String, String> headers) {
    private static final Pattern CHARSET = Pattern.compile("<meta charset=\"utf-8\">");
    private static final Pattern TITLE = Pattern.compile("<title>[^<]*</title>");
    private static final Pattern DESCRIPTION = Pattern.compile("<meta name=\"description\" content=\"[^\"]*\">");
    private static final Pattern HEAD_END = Pattern.compile("</head>");
    private static final Pattern BODY = Pattern.compile("<body[^>]*>");
    private static final Pattern MODEL_FILES =
            Pattern.compile("<meta name=\"jsm-model-files\" content=\"([\\w./ -]+)\">");
    private static final Pattern NOSCRIPT_END = Pattern.compile("</noscript>");

    /**
     * Checks that the page has all places that are filled in.
     *
     * @param html see {@link #html()}
     * @param headers see {@link #headers()}
     * @throws IllegalArgumentException when one is missing
     */
    public PageTemplate {
        headers = Map.copyOf(headers);
        for (Pattern place : new Pattern[] {CHARSET, TITLE, DESCRIPTION, HEAD_END, BODY, NOSCRIPT_END})
            if (!place.matcher(html).find())
                throw new IllegalArgumentException("the page has nothing like " + place + ": give it that element");
    }

    /**
     * Makes the page of a model.
     *
     * @param segment the model's id as a part of an address
     * @param manifest of the model as JSON, or its {@code id} and {@code name} alone while it has no archive; its
     *     addresses are relative to {@code m/{id}/}
     * @param poster a JPEG file, or null for none
     * @param root address of the folder of the template, which ends with a slash, or null when it is not known
     * @return the page as HTML
     * @throws IllegalArgumentException when the manifest is no JSON object
     */
    public String page(String segment, String manifest, byte[] poster, String root) {
        PageWords words = new PageWords(segment, manifest, poster, root);
        String page = after(CHARSET, html, "\n    <base href=\"../../\">");
        page = instead(TITLE, page, "<title>" + words.title() + "</title>");
        page = instead(DESCRIPTION, page, "<meta name=\"description\" content=\"" + words.description() + "\">");
        page = before(HEAD_END, page, words.tags());
        page = before(NOSCRIPT_END, page, words.facts());
        return after(BODY, page, words.first() + "\n  " + words.hints() + hints());
    }

    /**
     * The scripts of a model's page, which would else be asked for one after the other. Behind the poster, because they
     * would share the link with it, and before all else, because nothing of the rest is needed for them.
     */
    private String hints() {
        Matcher named = MODEL_FILES.matcher(html);
        if (!named.find()) return "";
        StringBuilder hints = new StringBuilder();
        for (String path : named.group(1).split(" ")) {
            String as = path.endsWith(".js") ? "modulepreload" : "preload\" as=\"fetch\" crossorigin=\"anonymous";
            hints.append("  <link rel=\"")
                    .append(as)
                    .append("\" href=\"")
                    .append(path)
                    .append("\">\n  ");
        }
        return hints.toString();
    }

    private static String after(Pattern place, String page, String text) {
        return instead(place, page, place(place, page) + text);
    }

    private static String before(Pattern place, String page, String text) {
        return instead(place, page, text + place(place, page));
    }

    private static String place(Pattern place, String page) {
        Matcher found = place.matcher(page);
        return found.find() ? found.group() : "";
    }

    private static String instead(Pattern place, String page, String text) {
        return place.matcher(page).replaceFirst(Matcher.quoteReplacement(text));
    }
}

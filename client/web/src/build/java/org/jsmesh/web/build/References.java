package org.jsmesh.web.build;

import java.util.regex.Pattern;

/** How sources name other files: the first group of each pattern is a path relative to the file that holds it. */
final class References {
    /** Of scripts, as other bundlers know it too. */
    static final Pattern OF_SCRIPTS = Pattern.compile("(?<=new URL\\(')(\\.{1,2}/[^'$]+)(?=', import\\.meta\\.url\\))");

    static final Pattern OF_PAGES = Pattern.compile("(?<= (?:src|href)=\")([^\":?#]+)(?=\")");

    private References() {}
}

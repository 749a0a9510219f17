package org.jsmesh.web.build;

import java.util.List;
import java.util.Map;

/**
 * A script that was bundled.
 *
 * @param name of its file
 * @param imports names of the files that it loads at once
 * @param later files that it loads when they are needed, each with those that it loads at once, by their sources
 */
record Bundle(String name, List<String> imports, Map<String, List<String>> later) {}

package org.jsmesh.session;

import java.nio.file.Path;
import java.util.Locale;

/** The folder where programs of this user keep archives, by the rules of the operating system. */
public final class UserCache {
    private UserCache() {}

    /** {@return the folder for {@link SessionOptions#withCache}; made when it is first used} */
    public static Path folder() {
        String system = System.getProperty("os.name", "").toLowerCase(Locale.ROOT);
        Path home = Path.of(System.getProperty("user.home", "."));
        return base(system, home).resolve("jsm").resolve("archives");
    }

    private static Path base(String system, Path home) {
        if (system.contains("mac")) return home.resolve("Library/Caches");
        String variable = System.getenv(system.contains("win") ? "LOCALAPPDATA" : "XDG_CACHE_HOME");
        return variable == null || variable.isBlank() ? home.resolve(".cache") : Path.of(variable);
    }
}

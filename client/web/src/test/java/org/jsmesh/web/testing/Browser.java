package org.jsmesh.web.testing;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.URI;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Base64;
import java.util.List;
import java.util.Map;
import java.util.logging.Level;
import javax.imageio.ImageIO;
import org.jsmesh.test.Requirement;
import org.openqa.selenium.By;
import org.openqa.selenium.OutputType;
import org.openqa.selenium.chrome.ChromeDriver;
import org.openqa.selenium.chrome.ChromeDriverService;
import org.openqa.selenium.chrome.ChromeOptions;
import org.openqa.selenium.logging.LogEntry;
import org.openqa.selenium.logging.LogType;
import org.openqa.selenium.logging.LoggingPreferences;

/**
 * A headless Chromium with a profile of its own, drawing in software. Skips the test where there is none (see
 * {@link Requirement}).
 */
public final class Browser implements AutoCloseable {
    private static final Duration PATIENCE = Duration.ofSeconds(120);

    /** This machine by a name that browsers do not trust. */
    public static final String INSECURE_HOST = "jsm.test";

    private final ChromeDriver driver;

    /** @param profile an empty folder */
    public Browser(Path profile) {
        this(profile, List.of());
    }

    /**
     * One for tests of what the page does, not of its looks: a processor draws its pictures in a third of the time.
     * They have a quarter of the pixels, and no antialiasing.
     *
     * @param profile an empty folder
     */
    public static Browser drawingCoarsely(Path profile) {
        return new Browser(profile, List.of("--force-device-scale-factor=0.5", "--webgl-antialiasing-mode=none"));
    }

    private Browser(Path profile, List<String> more) {
        Requirement.Browser found = Requirement.browser();
        ChromeOptions options = new ChromeOptions();
        options.setBinary(found.chromium().toFile());
        options.addArguments(
                "--headless",
                "--no-sandbox",
                "--disable-quic",
                "--no-first-run",
                "--disable-background-networking",
                "--disable-component-update",
                "--disable-sync",
                "--disable-dev-shm-usage",
                "--enable-unsafe-swiftshader",
                "--window-size=1000,700",
                // A name that is no localhost, so that pages from it are as those of a server without encryption.
                "--host-resolver-rules=MAP " + INSECURE_HOST + " 127.0.0.1",
                "--user-data-dir=" + profile);
        options.addArguments(more);
        LoggingPreferences logging = new LoggingPreferences();
        logging.enable(LogType.BROWSER, Level.ALL);
        options.setCapability("goog:loggingPrefs", logging);
        ChromeDriverService service = new ChromeDriverService.Builder()
                .usingDriverExecutable(found.driver().toFile())
                .usingAnyFreePort()
                .build();
        driver = new ChromeDriver(service, options);
        driver.manage().timeouts().scriptTimeout(PATIENCE).pageLoadTimeout(PATIENCE);
    }

    public void open(URI page) {
        driver.get(page.toString());
    }

    /** Forgets everything that was fetched, so that the next page fetches it again. */
    public void forget() {
        driver.executeCdpCommand("Network.clearBrowserCache", Map.of());
    }

    /** Runs a script before those of each page that is opened meanwhile. */
    public void before(String script, Runnable meanwhile) {
        Object id = driver.executeCdpCommand("Page.addScriptToEvaluateOnNewDocument", Map.of("source", script))
                .get("identifier");
        try {
            meanwhile.run();
        } finally {
            driver.executeCdpCommand("Page.removeScriptToEvaluateOnNewDocument", Map.of("identifier", id));
        }
    }

    /** Frees what no script can reach any more. */
    public void collectGarbage() {
        driver.executeCdpCommand("HeapProfiler.collectGarbage", Map.of());
    }

    /** Gives the window another size inside. */
    public void resize(int width, int height) {
        driver.executeCdpCommand(
                "Emulation.setDeviceMetricsOverride",
                Map.of("width", width, "height", height, "deviceScaleFactor", 0, "mobile", false));
    }

    /**
     * Runs the body of an asynchronous function in the page and gives what it returns; arguments are in {@code args}.
     */
    public Object call(String body, Object... args) {
        String script = "const done = arguments[arguments.length - 1]; const args = [...arguments].slice(0, -1);"
                + "(async () => {" + body
                + "})().then(value => done({value}), error => done({error: `${error?.stack ?? error}`}));";
        Map<?, ?> answer = (Map<?, ?>) driver.executeAsyncScript(script, args);
        if (answer.get("error") != null) throw new AssertionError("in the page: " + answer.get("error"));
        return answer.get("value");
    }

    /** Waits until an expression holds in the page and what is shown has had a frame to follow. */
    public void await(String expression) {
        call("const end = performance.now() + " + (PATIENCE.toMillis() - 20_000) + ";"
                + "while (!(" + expression + ")) {"
                + "  if (performance.now() > end) throw new Error('never: " + expression.replace("'", "\\'")
                + "; ' + JSON.stringify(window.jsm ?? null, "
                + "['state', 'error', 'faces', 'bytes', 'totalBytes']));"
                + "  await new Promise(resolve => setTimeout(resolve, 20));"
                + "}"
                + "await new Promise(resolve => requestAnimationFrame(() => requestAnimationFrame(resolve)));");
    }

    public void click(String selector) {
        driver.findElement(By.cssSelector(selector)).click();
    }

    public String text(String selector) {
        return driver.findElement(By.cssSelector(selector)).getText();
    }

    public boolean isShown(String selector) {
        return driver.findElement(By.cssSelector(selector)).isDisplayed();
    }

    /**
     * Errors on the console since the last call: failed requests, violations of the Content-Security-Policy, uncaught
     * exceptions.
     */
    public List<String> consoleErrors() {
        return driver.manage().logs().get(LogType.BROWSER).getAll().stream()
                .filter(entry -> entry.getLevel().intValue() >= Level.SEVERE.intValue())
                .map(LogEntry::getMessage)
                .toList();
    }

    /** What the window shows. */
    public BufferedImage screenshot() {
        return decode(driver.getScreenshotAs(OutputType.BYTES));
    }

    /** The viewer's picture alone, on a transparent background. */
    public BufferedImage snapshot(int width, int height) {
        return picture((String) call("return jsm.snapshot(args[0], args[1]);", width, height));
    }

    static BufferedImage picture(String dataUrl) {
        return decode(Base64.getDecoder().decode(dataUrl.substring(dataUrl.indexOf(',') + 1)));
    }

    @Override
    public void close() {
        driver.quit();
    }

    private static BufferedImage decode(byte[] png) {
        try {
            return ImageIO.read(new ByteArrayInputStream(png));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}

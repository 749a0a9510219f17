package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import javax.imageio.ImageIO;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.files.ModelEncoding;
import org.jsmesh.mesh.ProgressListener;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.jsmesh.upload.UploadSettings;
import org.jsmesh.upload.UploadTokens;
import org.jsmesh.web.testing.Browser;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** Files of the visitor's device: archives are shown without the server, models are sent to it. */
@Timeout(300)
class PageLocalTest {
    private static final String TOKEN = "0123456789abcdef0123456789abcdef";
    private static final String OBJ = "mtllib pyramid.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\n"
            + "usemtl stone\nf 1/1 3/2 2/3\nf 1/1 2/2 4/3\nf 2/1 3/2 4/3\nf 3/1 1/2 4/3\n";
    private static final String MTL = "newmtl stone\nKd 1 1 1\nmap_Kd stone.png\n";

    @TempDir
    private Path folder;

    private ModelStore store;
    private JsmServer server;
    private Browser browser;

    @BeforeEach
    void start() throws IOException {
        Path models = Files.createDirectory(folder.resolve("models"));
        Path tokens = Files.writeString(folder.resolve("tokens"), TOKEN + "\n");
        store = new ModelStore(
                StoreSettings.of(models).withCache(folder.resolve("cache")),
                new ModelFilesEncoder(EncoderSettings.defaults()));
        store.acceptUploads(UploadSettings.of(UploadTokens.read(tokens)));
        server = JsmServer.start(ServerSettings.defaults(), store);
        browser = new Browser(Files.createDirectory(folder.resolve("profile")));
    }

    @AfterEach
    void stop() throws IOException {
        if (browser != null) browser.close();
        if (server != null) server.close();
        if (store != null) store.close();
    }

    @Test
    void shouldShowArchivesThatAreDroppedAndSendModels() throws IOException {
        browser.open(server.uri());
        browser.await("document.querySelector('.pick button')");
        Path first = archive("first", 60, 20);
        drop(List.of(file("first.jsm", Files.readAllBytes(first))));
        browser.await("window.jsm?.state === 'complete'");
        assertThat(browser.call("return jsm.identical && jsm.faces === jsm.totalFaces;"))
                .isEqualTo(true);
        assertThat(browser.text("#title")).isEqualTo("first");
        assertThat(browser.call("return performance.getEntriesByType('resource').some(r => r.name.includes('.jsm'));"))
                .as("asks the server for nothing of the archive")
                .isEqualTo(false);

        Path second = archive("second", 40, 30);
        drop(List.of(file("second.jsm", Files.readAllBytes(second))));
        browser.await("document.title.startsWith('second') && jsm.state === 'complete'");
        assertThat(((Number) browser.call("return jsm.faces;")).intValue()).isEqualTo(2400);
        assertThat(browser.call("return location.search;")).isEqualTo("?file=second.jsm");
        browser.call("history.back();");
        browser.await("document.querySelector('.pick button') && location.search === ''");

        drop(List.of(file("notes.txt", new byte[] {1})));
        browser.await("document.querySelector('dialog.local')");
        assertThat(browser.text("dialog.local")).contains("This is no model", "notes.txt");
        assertThat(browser.consoleErrors()).isEmpty();
        drop(List.of(
                file("pyramid.obj", OBJ.getBytes()), file("pyramid.mtl", MTL.getBytes()), file("stone.png", png())));
        browser.await("document.querySelector('dialog.local input[type=password]')");
        send("wrong");
        browser.await("document.querySelector('dialog.local .bad')");
        assertThat(browser.text("dialog.local .bad")).contains("does not know this token");
        assertThat(browser.consoleErrors()).singleElement().asString().contains("401");
        send(TOKEN);
        browser.await("location.pathname === '/m/pyramid/' && window.jsm?.header?.whole");
        browser.call("await jsm.complete();");
        assertThat(browser.call("return jsm.identical && jsm.header.slots.map(s => s.textures.COLOUR?.path).join();"))
                .asString()
                .contains("stone.png");
        assertThat(browser.consoleErrors()).isEmpty();

        browser.await("document.querySelector('.tools')");
        browser.click(".tools [aria-label='Download']");
        browser.await("document.querySelector('.originals button')");
        browser.click(".originals button[title='OBJ']");
        browser.await("document.querySelector('.originals + p').textContent === 'pyramid.zip saved.'");
        Path large = GrainyTorus.write(folder.resolve("large.ply"), 200, 55);
        String page = (String) browser.call("return location.href;");
        encodeHere(file("large.ply", Files.readAllBytes(large)));
        browser.await("/^Encoding: .*, \\d+%$/.test(document.querySelector('dialog.local .soft').textContent)");
        browser.call(
                "[...document.querySelectorAll('dialog.local button')].find((b) => b.textContent === 'Cancel').click();");
        browser.await("!document.querySelector('dialog.local')");
        assertThat(browser.call("return location.href;")).isEqualTo(page);

        encodeHere(file("pyramid.obj", OBJ.getBytes()));
        browser.await("location.search === '?file=pyramid.jsm' && window.jsm.state === 'complete'");
        assertThat(browser.call("return jsm.faces;")).isEqualTo(4L);
        assertThat(browser.text("#proof-text")).contains("not the whole original");
        assertThat(browser.consoleErrors()).isEmpty();
    }

    private Path archive(String name, int around, int across) throws IOException {
        Path model = GrainyTorus.write(folder.resolve(name + ".ply"), around, across);
        Path archive = folder.resolve(name + ".jsm");
        new ModelEncoding(EncoderSettings.defaults()).write(model, archive, ProgressListener.NONE);
        return archive;
    }

    private static byte[] png() throws IOException {
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(new BufferedImage(4, 4, BufferedImage.TYPE_INT_RGB), "png", png);
        return png.toByteArray();
    }

    private static List<String> file(String name, byte[] content) {
        return List.of(name, Base64.getEncoder().encodeToString(content));
    }

    private void drop(List<List<String>> files) {
        browser.call(
                "const dataTransfer = new DataTransfer(); for (const [name, content] of args[0])"
                        + "  dataTransfer.items.add(new File([Uint8Array.from(atob(content), c => c.charCodeAt(0))], name));"
                        + "document.body.dispatchEvent("
                        + "  new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));",
                files);
    }

    private void encodeHere(List<String> file) {
        drop(List.of(file));
        browser.await("document.querySelectorAll('dialog.local .act').length === 2");
        browser.click("dialog.local .act:not(.primary)");
    }

    private void send(String token) {
        browser.call(
                "document.querySelector('dialog.local input[type=password]').value = args[0];"
                        + "document.querySelector('dialog.local .primary').click();",
                token);
    }
}

package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jsmesh.app.server.JsmServer;
import org.jsmesh.app.server.ServerSettings;
import org.jsmesh.encode.EncoderSettings;
import org.jsmesh.sandbox.ModelFilesEncoder;
import org.jsmesh.store.ModelStore;
import org.jsmesh.store.StoreSettings;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** What {@code jsm serve} says when it cannot serve. */
@Timeout(120)
class ServeCommandTest {
    @TempDir
    Path folder;

    @TempDir
    Path other;

    @BeforeEach
    void writeModel() throws IOException {
        Bumpy.write(folder.resolve("bumpy.ply"), 12);
    }

    @Test
    void shouldRefuseAPortThatIsInUse() throws Exception {
        StoreSettings settings = StoreSettings.of(folder).withCache(other.resolve("cache"));
        try (ModelStore store = new ModelStore(settings, new ModelFilesEncoder(EncoderSettings.defaults()));
                JsmServer server = JsmServer.start(ServerSettings.defaults(), store)) {
            ServerSettings same = ServerSettings.defaults()
                    .withAddress("127.0.0.1", server.uri().getPort());
            assertThatThrownBy(() -> JsmServer.start(same, store)).isInstanceOf(IOException.class);
            Cli cli = Cli.run("serve", folder, "--port", server.uri().getPort());
            assertThat(cli.code()).isEqualTo(1);
            assertThat(cli.err()).contains("Choose another one with --port").hasLineCount(1);
            Cli elsewhere = Cli.run("serve", folder, "--host", "no.such.host.invalid", "--port", "0");
            assertThat(elsewhere.code()).isEqualTo(1);
            assertThat(elsewhere.err()).contains("--host").hasLineCount(1);
        }
    }

    @Test
    void shouldSayThatThereIsNothingToServe() {
        Cli cli = Cli.run("serve", other.resolve("nowhere"), "--port", "0");
        assertThat(cli.code()).isEqualTo(1);
        assertThat(cli.err()).contains("nowhere").hasLineCount(1);
        assertThat(Cli.run("serve", folder, "--port", "70000").code()).isEqualTo(2);
    }

    @Test
    void shouldSayThatAKeystoreCannotBeOpened() throws IOException {
        Cli missing = Cli.run("serve", folder, "--port", "0", "--tls-keystore", other.resolve("none.p12"));
        assertThat(missing.code()).isEqualTo(1);
        assertThat(missing.err()).contains("none.p12").hasLineCount(1);
        Path damaged = Files.writeString(other.resolve("damaged.p12"), "no keystore");
        Cli unreadable = Cli.run("serve", folder, "--port", "0", "--tls-keystore", damaged);
        assertThat(unreadable.code()).isEqualTo(1);
        assertThat(unreadable.err()).contains("damaged.p12").hasLineCount(1);
    }
}

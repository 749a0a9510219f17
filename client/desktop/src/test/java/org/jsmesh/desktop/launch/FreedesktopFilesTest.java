package org.jsmesh.desktop.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;

class FreedesktopFilesTest {
    private static String exec(String script) {
        return FreedesktopFiles.entry(script)
                .lines()
                .filter(line -> line.startsWith("Exec="))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void shouldNameWhatTheViewerOpens() {
        assertThat(FreedesktopFiles.entry("/home/u/open").lines())
                .startsWith("[Desktop Entry]", "Type=Application")
                .contains("MimeType=x-scheme-handler/jsm;model/vnd.jsm;", "Exec=/home/u/open %u");
    }

    @Test
    void shouldQuoteWhereTheSpecificationSaysSo() {
        assertThat(exec("/home/a b/open")).isEqualTo("Exec=\"/home/a b/open\" %u");
        assertThat(exec("/home/100%/open")).isEqualTo("Exec=/home/100%%/open %u");
        assertThat(exec("/a$b`c\"d\\e")).isEqualTo("Exec=\"/a\\\\$b\\\\`c\\\\\"d\\\\\\\\e\" %u");
    }

    @Test
    void shouldStartTheViewerWithoutTakingALinkForAnOption() {
        assertThat(FreedesktopFiles.script(List.of("/usr/bin/java", "-jar", "/home/it's mine/jsm-viewer.jar")))
                .endsWith("\nexec '/usr/bin/java' '-jar' '/home/it'\\''s mine/jsm-viewer.jar' -- \"$@\"\n");
    }

    @Test
    void shouldDescribeArchives() throws Exception {
        byte[] types = FreedesktopFiles.types().getBytes(StandardCharsets.UTF_8);
        var type = DocumentBuilderFactory.newInstance()
                .newDocumentBuilder()
                .parse(new ByteArrayInputStream(types))
                .getElementsByTagName("mime-type");
        assertThat(type.getLength()).isEqualTo(1);
        assertThat(type.item(0).getAttributes().getNamedItem("type").getNodeValue())
                .isEqualTo("model/vnd.jsm");
    }

    @Test
    void shouldTakeItsOwnEntriesAloneOutOfAList() {
        String list = """
                [Default Applications]
                text/html=firefox.desktop
                x-scheme-handler/jsm=jsm-viewer.desktop
                model/vnd.jsm=jsm-viewer.desktop;other.desktop;
                model/stl=jsm-viewer.desktop

                [Added Associations]
                x-scheme-handler/jsm=jsm-viewer.desktop;
                """;
        assertThat(FreedesktopFiles.without(list)).isEqualTo("""
                [Default Applications]
                text/html=firefox.desktop
                model/vnd.jsm=other.desktop;
                model/stl=jsm-viewer.desktop

                [Added Associations]
                """);
        assertThat(FreedesktopFiles.without("[Added Associations]\n")).isEqualTo("[Added Associations]\n");
    }
}

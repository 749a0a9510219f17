package org.jsmesh.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.util.List;
import org.jsmesh.test.Requirement;
import org.jsmesh.test.SampleModels;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/** What people need who hear the page, see little of it or use no pointer, as far as axe-core can tell. */
class PageAccessTest extends PageFixture {
    private static final String FAULTS = """
            const { violations } = await axe.run();
            return violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(' ')).join(', ')}`);
            """;

    private String axe;

    @BeforeAll
    void readAxe() throws IOException {
        Requirement.node();
        axe = Files.readString(SampleModels.project().resolve("client/web/node_modules/axe-core/axe.min.js"));
    }

    @Test
    void shouldFindNothingInTheGallery() {
        open("");
        browser.await("document.querySelector('#pick-file') && document.querySelector('#cards a')");
        assertNoFaults("gallery");
    }

    @Test
    void shouldFindNothingInTheErrors() {
        open("m=nothing");
        browser.await("window.jsm?.state === 'error'");
        assertNoFaults("no such model");
    }

    @Test
    void shouldFindNothingAroundAModel() {
        browser.open(proxy.through(URI.create("http://127.0.0.1/m/torus/")));
        browser.await("window.jsm?.state === 'idle' || window.jsm?.state === 'complete'");
        browser.await("document.querySelector('.tools')");
        assertNoFaults("refined once");
        browser.call("await jsm.complete();");
        assertNoFaults("complete");
        List<?> tools = (List<?>) browser.call("""
                return [...document.querySelectorAll('.tools [aria-controls]')].map(({ ariaLabel, title }) => ariaLabel ?? title);
                """);
        assertThat(tools).hasSizeGreaterThan(4);
        for (int i = 0; i < tools.size(); i++) {
            browser.call("document.querySelectorAll('.tools [aria-controls]')[args[0]].click();", i);
            browser.await("document.querySelector('#tool .controls')?.children.length > 0");
            assertNoFaults(tools.get(i).toString());
            browser.call("document.querySelectorAll('.tools [aria-controls]')[args[0]].click();", i);
        }
        browser.click("#options summary");
        assertNoFaults("the menu");
    }

    private void assertNoFaults(String state) {
        if (browser.call("return window.axe === undefined;").equals(true)) browser.call(axe);
        assertThat((List<?>) browser.call(FAULTS)).as(state).isEmpty();
    }
}

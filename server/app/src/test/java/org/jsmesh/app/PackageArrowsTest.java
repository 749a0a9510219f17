package org.jsmesh.app;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.core.importer.ImportOption;
import org.junit.jupiter.api.Test;

/** The packages of all modules that the command brings together. */
class PackageArrowsTest {
    private static final JavaClasses CLASSES = new ClassFileImporter()
            .withImportOption(new ImportOption.DoNotIncludeTests())
            .withImportOption(location -> !location.contains("-tests.jar") && !location.contains("test-classes"))
            .importPackages("org.jsmesh");

    @Test
    void shouldHaveNoCycles() {
        assertThat(CLASSES).hasSizeGreaterThan(400);
        slices().matching("org.jsmesh.(**)").should().beFreeOfCycles().check(CLASSES);
    }

    @Test
    void shouldKnowTheCommandOnlyInItsOwnPackage() {
        noClasses()
                .that()
                .resideOutsideOfPackage("org.jsmesh.app")
                .should()
                .dependOnClassesThat()
                .resideInAPackage("org.jsmesh.app")
                .check(CLASSES);
    }

    @Test
    void shouldServeAndMeasureWithoutTheClient() {
        noClasses()
                .that()
                .resideInAnyPackage("org.jsmesh.app.server", "org.jsmesh.app.bench")
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage("org.jsmesh.session..", "info.picocli..", "picocli..")
                .check(CLASSES);
    }
}

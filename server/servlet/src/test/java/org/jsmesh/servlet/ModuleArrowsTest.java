package org.jsmesh.servlet;

import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;

/** Holds the module to its place: a guest that brings along no page, no container and no client. */
class ModuleArrowsTest {
    private static final JavaClasses CLASSES = new ClassFileImporter().importPath(Path.of("target/classes"));

    @Test
    void shouldKnowNoPageAndNoContainer() {
        noClasses()
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage(
                        "org.jsmesh.web..",
                        "org.jsmesh.webapp..",
                        "org.jsmesh.session..",
                        "org.eclipse.jetty..",
                        "org.apache.catalina..",
                        "org.springframework..")
                .check(CLASSES);
    }

    @Test
    void shouldLeaveServletsToTheServletPackage() {
        noClasses()
                .that()
                .resideOutsideOfPackage("org.jsmesh.servlet..")
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage("org.jsmesh.servlet..", "jakarta.servlet..")
                .check(CLASSES);
    }

    @Test
    void shouldAnswerWithoutKnowingModels() {
        classes()
                .that()
                .resideInAPackage("org.jsmesh.servlet.http")
                .should()
                .onlyDependOnClassesThat()
                .resideInAnyPackage("org.jsmesh.servlet.http", "jakarta.servlet..", "com.fasterxml.jackson..", "java..")
                .check(CLASSES);
    }

    @Test
    void shouldHaveNoCycles() {
        slices().matching("org.jsmesh.(**)").should().beFreeOfCycles().check(CLASSES);
    }
}

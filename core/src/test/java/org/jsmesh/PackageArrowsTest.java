package org.jsmesh;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClass;
import java.nio.file.Path;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Holds core to the package table of the architecture. */
class PackageArrowsTest {
    static Stream<String> packages() {
        return CorePackages.ARROWS.keySet().stream().sorted();
    }

    @ParameterizedTest
    @MethodSource("packages")
    void shouldUseOnlyWhatItsArrowsAllow(String name) {
        classes()
                .that()
                .resideInAPackage(CorePackages.BASE + name)
                .should()
                .onlyDependOnClassesThat(resideInAnyPackage(CorePackages.reach(name))
                        .or(resideInAnyPackage("java..", "javax.xml.stream..")))
                .check(CorePackages.CLASSES);
    }

    @Test
    void shouldKnowEveryPackage() {
        Set<String> found = CorePackages.CLASSES.stream()
                .map(type -> type.getPackageName().substring(CorePackages.BASE.length()))
                .collect(Collectors.toSet());

        assertThat(found).isEqualTo(CorePackages.ARROWS.keySet());
    }

    @Test
    void shouldHaveNoCycles() {
        slices().matching("org.jsmesh.(**)").should().beFreeOfCycles().check(CorePackages.CLASSES);
    }

    @ParameterizedTest
    @MethodSource("packages")
    void shouldSayWhatThePackageIs(String name) {
        Path folder = Path.of("src/main/java/org/jsmesh", name.split("\\."));
        assertThat(folder.resolve("package-info.java")).exists();
    }

    @Test
    void shouldTouchNeitherFilesNorThreadsOfItsOwnButLocks() {
        noClasses()
                .that()
                .resideOutsideOfPackage(CorePackages.BASE + "lock")
                .should()
                .dependOnClassesThat(describe(
                        "reach files, sockets or thread pools",
                        (JavaClass type) -> type.getPackageName().startsWith("java.nio.file")
                                || type.getPackageName().startsWith("java.net")
                                || type.getPackageName().startsWith("java.nio.channels")
                                || FILES_AND_POOLS.contains(type.getName())))
                .orShould()
                .callConstructor(Thread.class, Runnable.class)
                .check(CorePackages.CLASSES);
    }

    private static final Set<String> FILES_AND_POOLS = Set.of(
            "java.io.File",
            "java.io.FileInputStream",
            "java.io.FileOutputStream",
            "java.io.FileReader",
            "java.io.FileWriter",
            "java.io.RandomAccessFile",
            "java.util.concurrent.Executors",
            "java.util.concurrent.ForkJoinPool",
            "java.util.concurrent.ThreadPoolExecutor");
}

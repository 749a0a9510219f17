package org.jsmesh;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.AccessTarget.CodeUnitCallTarget;
import com.tngtech.archunit.core.domain.JavaCall;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import java.util.Map;
import java.util.Set;
import org.jsmesh.mesh.KeyHash;
import org.jsmesh.mesh.TupleHash;
import org.junit.jupiter.api.Test;

/**
 * The decoder runs in the browser: it needs nothing of the encoder, and nothing of the JDK that TeaVM lacks or computes
 * differently.
 */
class DecoderClosureTest {
    private static final JavaClasses DECODER =
            CorePackages.CLASSES.that(describe("belong to the decoder", CorePackages::isOfDecoder));

    /** Exact on HotSpot, WebAssembly and JavaScript alike. */
    private static final Set<String> EXACT_MATH = Set.of(
            "abs",
            "min",
            "max",
            "sqrt",
            "floor",
            "ceil",
            "floorDiv",
            "floorMod",
            "addExact",
            "subtractExact",
            "multiplyExact",
            "toIntExact",
            "negateExact",
            "incrementExact",
            "signum");

    /** Methods that TeaVM's otherwise present classes lack, run on one thread only, or answer differently. */
    private static final Map<String, Set<String>> MISSING = Map.of(
            "java.util.Arrays",
            Set.of("parallelSort", "parallelPrefix", "parallelSetAll", "compare", "compareUnsigned", "mismatch"),
            "java.util.Collection",
            Set.of("parallelStream"),
            "java.util.stream.BaseStream",
            Set.of("parallel"),
            "java.lang.System",
            Set.of("getLogger", "getenv", "load", "loadLibrary"));

    @Test
    void shouldNotUseTheEncoder() {
        noClasses()
                .should()
                .dependOnClassesThat(describe(
                        "are of core but not of the decoder",
                        (JavaClass type) ->
                                type.getName().startsWith(CorePackages.BASE) && !CorePackages.isOfDecoder(type)))
                .check(DECODER);
    }

    @Test
    void shouldUseOnlyClassesThatTeaVmHas() {
        noClasses()
                .should()
                .dependOnClassesThat(describe("TeaVM's class library lacks", DecoderClosureTest::isMissing))
                .check(DECODER);
    }

    @Test
    void shouldUseOnlyMethodsThatTeaVmHas() {
        noClasses().should().callMethodWhere(calls(MISSING)).check(DECODER);
    }

    /**
     * Random is there, but yields other numbers; the transcendental functions differ in their last bits. Where keys lie
     * in a table shows nowhere.
     */
    @Test
    void shouldComputeTheSameEverywhere() {
        noClasses()
                .that()
                .doNotBelongToAnyOf(KeyHash.class, TupleHash.class)
                .should()
                .dependOnClassesThat()
                .haveFullyQualifiedName("java.util.Random")
                .orShould()
                .callMethodWhere(describe(
                        "Math beyond + - * / and sqrt",
                        (JavaCall<?> call) -> call.getTargetOwner().isEquivalentTo(Math.class)
                                && !EXACT_MATH.contains(call.getName())))
                .check(CorePackages.CLASSES.that(describe("must be exact", CorePackages::isExact)));
    }

    @Test
    void shouldNotBeFooledByTheRulesThemselves() {
        assertThat(isMissing(CorePackages.CLASSES.get("org.jsmesh.mesh.Mesh"))).isFalse();
        assertThat(hasTeaVm("java.util.BitSet")).isTrue();
        assertThat(hasTeaVm("java.util.concurrent.CancellationException")).isTrue();
        assertThat(hasTeaVm("java.util.concurrent.CompletableFuture")).isFalse();
        assertThat(hasTeaVm("java.security.MessageDigest")).isFalse();
    }

    private static DescribedPredicate<JavaCall<?>> calls(Map<String, Set<String>> methods) {
        return describe("TeaVM lacks or changes", call -> {
            CodeUnitCallTarget target = call.getTarget();
            return methods.entrySet().stream()
                    .anyMatch(m -> m.getValue().contains(target.getName())
                            && target.getOwner().isAssignableTo(m.getKey()));
        });
    }

    /** Arrays and primitives are always there; what the compiler itself links (lambdas, records) TeaVM translates. */
    private static boolean isMissing(JavaClass type) {
        JavaClass element = type.getBaseComponentType();
        return element.getName().startsWith("java.")
                && !element.getPackageName().equals("java.lang.runtime")
                && !hasTeaVm(element.getName());
    }

    /** TeaVM keeps its version of {@code java.util.BitSet} as {@code org.teavm.classlib.java.util.TBitSet}. */
    private static boolean hasTeaVm(String name) {
        int dot = name.lastIndexOf('.');
        String path = "org/teavm/classlib/" + name.substring(0, dot).replace('.', '/') + "/T" + name.substring(dot + 1);
        String nested = path.replace("$", "$T");
        ClassLoader loader = DecoderClosureTest.class.getClassLoader();
        return loader.getResource(path + ".class") != null || loader.getResource(nested + ".class") != null;
    }
}

package org.jsmesh.web.build;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

class GlslTest {
    private static String shortened(String shader) {
        String script = Glsl.shortened("export default /* glsl */`" + shader + "`;");
        return script.substring("export default `".length(), script.length() - 2);
    }

    @Test
    void shouldLeaveOutWhatOnlyPeopleRead() {
        assertThat(shortened("\n\t// why\n\tvec3 a = b /* and */ * ( c + d );\n\n\tfloat e;\n"))
                .isEqualTo("vec3 a=b*(c+d);float e;\n");
    }

    @Test
    void shouldKeepLinesOfThePreprocessor() {
        assertThat(shortened("\n#ifdef USE_MAP // if\n\ta( );\n\t#define  X( y ) y\n#endif\nb();"))
                .isEqualTo("\n#ifdef USE_MAP\na();\n#define X( y ) y\n#endif\nb();\n");
    }

    @Test
    void shouldNotMakeOneSignOrWordOfTwo() {
        assertThat(shortened("a = b - -c + +d;")).isEqualTo("a=b - -c + +d;\n");
        assertThat(shortened("return\nx;\na = b -\n-c;")).isEqualTo("return x;a=b - -c;\n");
        assertThat(shortened("x = 1.0\n- y;")).isEqualTo("x=1.0- y;\n");
    }

    @Test
    void shouldLeaveOtherTextsAlone() {
        String script = "const a = `x  =  1; // not a shader`;";
        assertThat(Glsl.shortened(script)).isEqualTo(script);
    }
}

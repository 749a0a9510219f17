package org.jsmesh.web.build;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import org.junit.jupiter.api.Test;

class FieldNamesTest {
    private static final String HEAD =
            "let U=superclass=>{return function(){};};function R(){this.$id$=0;}\nfunction A(){R.call(this);this.qa=0;}\n";

    @Test
    void shouldShareNamesBetweenClassesThatDoNotExtendEachOther() {
        assertThat(FieldNames.shared(HEAD + "function B(){let a=this;R.call(a);a.qb=null;a.qc=0.0;}\nx.qa=y.qb.qc;"))
                .endsWith("this.a=0;}\nfunction B(){let a=this;R.call(a);a.a=null;a.b=0.0;}\nx.a=y.a.b;");
    }

    @Test
    void shouldKeepNamesOfAClassApartFromThoseAboveIt() {
        assertThat(FieldNames.shared(HEAD + "let D=U(A),E=U();function B(){D.call(this);this.qb=null;}\nx.qa=x.qb;"))
                .endsWith("function B(){D.call(this);this.b=null;}\nx.a=x.b;");
    }

    @Test
    void shouldTakeNoNameThatMeansSomethingElse() {
        assertThat(FieldNames.shared(HEAD + "m([\"a\",f]);o={b:1};e.c=x.qa;")).endsWith("e.c=x.d;");
    }

    @Test
    void shouldLeaveTextsAndOtherPropertiesAlone() {
        String rest = "x.length+\"a \\\" this.qa\"+x.qab+qa();";
        assertThat(FieldNames.shared(HEAD + rest)).endsWith(rest);
    }

    @Test
    void shouldReadWhatGoesOnInTheNextLine() {
        assertThat(FieldNames.shared(HEAD + "function\nB(){let\na=this;R.call(a);a\n.qb=\nnull;a.qc=0;}\nx.\nqc=1;"))
                .endsWith("a.a=null;a.b=0;}\nx.b=1;");
    }

    @Test
    void shouldRefuseClassesAboveWhichItKnowsNothing() {
        assertThatThrownBy(() -> FieldNames.shared(HEAD + "function B(){K.call(this);this.qb=0;}"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("class K is not found");
    }

    @Test
    void shouldRefuseFieldsThatClassesShareAlready() {
        assertThatThrownBy(() -> FieldNames.shared(FieldNames.shared(HEAD + "function B(){R.call(this);this.qb=0;}")))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("two classes have a field a");
    }

    @Test
    void shouldRefuseOtherScripts() {
        assertThatThrownBy(() -> FieldNames.shared("let a = 1;"))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageContaining("no root of all classes");
    }
}

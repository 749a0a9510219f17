package org.jsmesh.desktop.panel;

import static org.assertj.core.api.Assertions.assertThat;

import javax.swing.JButton;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.JToolTip;
import javax.swing.plaf.basic.BasicHTML;
import org.junit.jupiter.api.Test;

class PlainLabelTest {
    private static final String PAGE = "<html><img src='http://127.0.0.1:1/x'>";

    @Test
    void shouldShowAPageAsLetters() {
        assertThat(isPage(new JLabel(PAGE))).isTrue();
        assertThat(isPage(new PlainLabel(PAGE))).isFalse();
        PlainLabel later = new PlainLabel("");
        later.setText(PAGE);
        assertThat(isPage(later)).isFalse();
        JButton button = PlainLabel.plain(new JButton());
        button.setText(PAGE);
        assertThat(isPage(button)).isFalse();
    }

    @Test
    void shouldDoSoInItsToolTipToo() {
        JToolTip tip = new PlainLabel("").createToolTip();
        tip.setTipText(PAGE);
        assertThat(isPage(tip)).isFalse();
    }

    @Test
    void shouldDoSoInEachLineOfAMessage() {
        assertThat(PlainLabel.lines("jsm:a\n\n" + PAGE)).hasSize(3).noneMatch(line -> isPage((JComponent) line));
    }

    private static boolean isPage(JComponent component) {
        return component.getClientProperty(BasicHTML.propertyKey) != null;
    }
}

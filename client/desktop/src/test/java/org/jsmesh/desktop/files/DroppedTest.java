package org.jsmesh.desktop.files;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.datatransfer.DataFlavor;
import java.awt.datatransfer.StringSelection;
import java.awt.datatransfer.Transferable;
import java.awt.datatransfer.UnsupportedFlavorException;
import java.io.File;
import java.util.Arrays;
import org.junit.jupiter.api.Test;

class DroppedTest {
    @Test
    void shouldTakeModelsAndLeaveWhatComesWithThem() {
        assertThat(Dropped.locations(files("chair.mtl", "chair.obj", "wood.png", "b.jsm")))
                .containsExactly("chair.obj", "b.jsm");
        assertThat(Dropped.locations(files("unknown.bin"))).containsExactly("unknown.bin");
    }

    @Test
    void shouldTakeAddressesFromText() {
        assertThat(Dropped.locations(new StringSelection("# from a page\r\n http://h/?m=a \n\nhttp://h/?m=b")))
                .containsExactly("http://h/?m=a", "http://h/?m=b");
        assertThat(Dropped.locations(new StringSelection(" \n"))).isEmpty();
        assertThat(Dropped.locations(null)).isEmpty();
    }

    private static Transferable files(String... names) {
        return new Transferable() {
            @Override
            public DataFlavor[] getTransferDataFlavors() {
                return new DataFlavor[] {DataFlavor.javaFileListFlavor, DataFlavor.stringFlavor};
            }

            @Override
            public boolean isDataFlavorSupported(DataFlavor flavor) {
                return Arrays.asList(getTransferDataFlavors()).contains(flavor);
            }

            @Override
            public Object getTransferData(DataFlavor flavor) throws UnsupportedFlavorException {
                if (!flavor.equals(DataFlavor.javaFileListFlavor)) throw new UnsupportedFlavorException(flavor);
                return Arrays.stream(names).map(File::new).toList();
            }
        };
    }
}

package org.jsmesh.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.jsmesh.s3.testing.S3Mock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ListingTest {
    @TempDir
    private Path folder;

    @ParameterizedTest
    @ValueSource(strings = {"", "\n\n", "# all gone\n"})
    void shouldRefuseAListWithoutAnAddress(String content) throws IOException {
        Path list = Files.writeString(folder.resolve("list.txt"), content);
        assertThatThrownBy(() -> new Listing().list(list.toString()))
                .isInstanceOf(CatalogueException.class)
                .hasMessageContaining("has no address of a model");
    }

    @Test
    void shouldReadAList() throws Exception {
        Path list = Files.writeString(
                folder.resolve("list.txt"), "s3://bucket/x/a.ply\tchairs/oak.ply\n\n# no\ns3://other/a.ply");
        Listing listing = new Listing();
        listing.list(list.toString());
        assertThat(listing.count()).isEqualTo(2);
        List<ListedModel> files = Packed.listed(listing.packed().get(0));
        assertThat(files).extracting(ListedModel::input).containsExactly("s3://bucket/x/a.ply", "s3://other/a.ply");
        assertThat(files).extracting(ListedModel::place).containsExactly("chairs/oak.ply", "a.ply");
        // Each store is tried before work begins.
        assertThat(Rights.samples(listing.packed()))
                .extracting(ListedModel::store)
                .containsExactly("s3://bucket", "s3://other");
    }

    @Test
    void shouldTellTheLineOfWhatIsNoAddress() throws IOException {
        Path list = Files.writeString(folder.resolve("list.txt"), "s3://bucket/a.ply\ns3://bucket/\n");
        assertThatThrownBy(() -> new Listing().list(list.toString())).hasMessageContaining("list.txt, line 2");
    }

    @Test
    void shouldSayWhatIsNotThere() {
        assertThatThrownBy(() -> new Listing().input(folder.resolve("nowhere").toString()))
                .isInstanceOf(CatalogueException.class)
                .hasMessageContaining("nowhere")
                .hasMessageContaining("no such file");
        S3Mock.shared();
        assertThatThrownBy(() -> new Listing().input("s3://no-such-bucket-anywhere/x"))
                .isInstanceOf(CatalogueException.class)
                .hasMessageContaining("no-such-bucket-anywhere");
    }
}

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
import software.amazon.awssdk.core.sync.RequestBody;

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

    @ParameterizedTest
    @ValueSource(strings = {"/", "..", "chairs//oak.ply", "/oak.ply", "oak\u0001.ply"})
    void shouldTellTheLineOfWhatIsNoPlace(String place) throws IOException {
        Path list = Files.writeString(folder.resolve("list.txt"), "# models\na.ply\t" + place + "\n");
        assertThatThrownBy(() -> new Listing().list(list.toString()))
                .isInstanceOf(CatalogueException.class)
                .hasMessage(list + ", line 2: '" + place
                        + "' is no place in a catalogue. Give one such as chairs/oak.obj, or none.");
    }

    @Test
    void shouldMakeARowOfANameThatNoFileCanHave() throws Exception {
        S3Mock s3 = S3Mock.shared();
        String bucket = s3.bucket();
        for (String key : List.of("p/a.ply", "p//two.ply", "p/notes//x.txt"))
            s3.client().putObject(b -> b.bucket(bucket).key(key), RequestBody.fromString("ply"));
        Listing listing = new Listing();
        listing.input("s3://" + bucket + "/p");
        List<ListedModel> files = Packed.listed(listing.packed().get(0));
        assertThat(files).extracting(ListedModel::key).containsExactly("/two.ply", "a.ply");
        assertThat(files).extracting(ListedModel::place).containsExactly("-/two.ply", "a.ply");
        CatalogueSettings settings = Cluster.settings("s3://" + bucket + "/p", folder.toString());
        PlanRow row = new PlanTask(settings, new Row.Stamp("run", settings.key(), 1)).plan("two", files.get(0), null);
        assertThat(row.is(PlanRow.Kind.REFUSED)).isTrue();
        assertThat(row.row().failure().reason()).contains("no key of an object", "/two.ply");
        assertThat(row.row().failure().remedy()).isNotEmpty();
    }

    @Test
    void shouldTakeAddressesOfFiles() throws Exception {
        Path file = Patches.write(folder.resolve("a ü/b.ply"), 4, 1);
        Path list = Files.writeString(folder.resolve("list.txt"), file.toUri() + "\tx.ply\n");
        Listing listing = new Listing();
        listing.list(list.toUri().toString());
        listing.input(file.getParent().toUri().toString());
        listing.input(file.toUri().toString());
        List<ListedModel> files = Packed.listed(listing.packed().get(0));
        assertThat(files)
                .extracting(ListedModel::input)
                .containsExactly(file.toString(), file.toString(), file.toString());
        assertThat(files).extracting(ListedModel::place).containsExactly("x.ply", "b.ply", "b.ply");
        assertThat(Listing.find(files.get(0))).isNotNull();
        Files.writeString(list, "a.ply\nfile://host/b.ply\n");
        assertThatThrownBy(() -> new Listing().list(list.toString()))
                .hasMessageStartingWith(list + ", line 2: file://host/b.ply: is no address of a file of this machine");
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

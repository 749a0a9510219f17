package org.jsmesh.s3;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileSystemException;
import java.util.ArrayList;
import java.util.List;
import org.jsmesh.objects.ObjectStore;
import org.jsmesh.objects.StoredObject;
import org.jsmesh.s3.testing.S3Mock;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import software.amazon.awssdk.core.sync.RequestBody;

@Timeout(60)
class S3ListingTest {
    private static String page(String more, String... keys) {
        StringBuilder page = new StringBuilder("<ListBucketResult><Name>bucket</Name>").append(more);
        for (String key : keys)
            page.append("<Contents><Key>").append(key).append("</Key><Size>1</Size><ETag>\"one\"</ETag></Contents>");
        return page.append("</ListBucketResult>").toString();
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "<NextContinuationToken></NextContinuationToken>"})
    void shouldNotTakeAPageForAllOfThem(String token) throws Exception {
        String page = page("<IsTruncated>true</IsTruncated>" + token, "p/a");
        try (FakeService service = new FakeService((exchange, number) -> FakeService.send(exchange, 200, page));
                ObjectStore store = service.store()) {
            assertThatThrownBy(() -> store.list("", "", object -> true))
                    .isInstanceOf(FileSystemException.class)
                    .hasMessageContaining("s3://bucket/p: the service says that the list goes on, but not where");
        }
    }

    @Test
    void shouldNotGoInCircles() throws Exception {
        String page = page("<IsTruncated>true</IsTruncated><NextContinuationToken>t</NextContinuationToken>", "p/a");
        try (FakeService service = new FakeService((exchange, number) -> FakeService.send(exchange, 200, page));
                ObjectStore store = service.store()) {
            assertThatThrownBy(() -> store.list("", "", object -> true))
                    .isInstanceOf(FileSystemException.class)
                    .hasMessageContaining("the same page of the list");
            assertThat(service.asked()).hasSize(2);
        }
    }

    @Test
    void shouldTellOfNamesThatAreNoKeys() throws Exception {
        List<String> asked = new ArrayList<>();
        String page = page(
                "<EncodingType>url</EncodingType>",
                "p/",
                "p//two.ply",
                "p/./z.ply",
                "p/a%01b.ply",
                "p/folder/",
                "p/g+%2B%C3%BC.ply",
                "p/x%5Cy.ply");
        Found found = new Found();
        try (FakeService service = new FakeService((exchange, number) -> {
                    asked.add(exchange.getRequestURI().getQuery());
                    FakeService.send(exchange, 200, page);
                });
                ObjectStore store = service.store()) {
            store.list("", "", found);
        }
        assertThat(asked).singleElement().asString().contains("encoding-type=url");
        assertThat(found.keys).containsExactly("g +ü.ply");
        assertThat(found.odd).containsExactly("/two.ply", "./z.ply", "a\001b.ply", "x\\y.ply");
        assertThat(found.reasons.get(3)).startsWith("s3://bucket/p/x\\y.ply: has a name that");
    }

    @Test
    void shouldGiveKeysAsTheyAreWritten() throws Exception {
        S3Mock mock = S3Mock.shared();
        String bucket = mock.bucket();
        List<String> keys = List.of("a b+c%20&d=e?.ply", "ü#.ply");
        for (String key : keys)
            mock.client().putObject(b -> b.bucket(bucket).key("p/" + key), RequestBody.fromString("x"));
        Found found = new Found();
        try (ObjectStore store = S3ObjectStore.at("s3://" + bucket + "/p")) {
            store.list("", "", found);
        }
        assertThat(found.keys).isEqualTo(keys);
        assertThat(found.odd).isEmpty();
    }

    private static final class Found implements ObjectStore.Visitor {
        private final List<String> keys = new ArrayList<>();
        private final List<String> odd = new ArrayList<>();
        private final List<String> reasons = new ArrayList<>();

        @Override
        public boolean visit(StoredObject object) {
            return keys.add(object.key());
        }

        @Override
        public void unnameable(String name, IOException reason) {
            odd.add(name);
            reasons.add(reason.getMessage());
        }
    }
}

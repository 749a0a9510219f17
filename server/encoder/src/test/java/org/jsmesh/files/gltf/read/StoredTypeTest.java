package org.jsmesh.files.gltf.read;

import static org.assertj.core.api.Assertions.assertThat;

import org.jsmesh.mesh.Channel;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class StoredTypeTest {
    private static StoredType of(String name) {
        boolean normalized = name.endsWith("n");
        String type = normalized ? name.substring(0, name.length() - 1) : name;
        return new StoredType(Channel.Type.valueOf(type), normalized);
    }

    @ParameterizedTest
    @CsvSource({
        "UINT8,UINT8,UINT8",
        "UINT8n,UINT8n,UINT8n",
        "UINT8,UINT16,UINT16",
        "INT8,INT16,INT16",
        "UINT8,INT8,INT16",
        "UINT16,INT8,INT32",
        "UINT16,UINT32,UINT32",
        "UINT32,INT8,FLOAT64",
        "UINT8n,UINT8,FLOAT32",
        "UINT8n,UINT16n,FLOAT32",
        "INT16,FLOAT32,FLOAT32",
        "UINT32,FLOAT32,FLOAT64",
        "FLOAT64,FLOAT32,FLOAT64",
        "INT32,UINT8,INT32"
    })
    void shouldHoldTheNumbersOfBoth(String a, String b, String both) {
        assertThat(of(a).with(of(b))).isEqualTo(of(both));
        assertThat(of(b).with(of(a))).isEqualTo(of(both));
    }

    @Test
    void shouldStoreNumbersAsChannelsReadThem() {
        int[] values = new int[2];
        for (String type : new String[] {"FLOAT64", "FLOAT32", "UINT32", "INT16", "UINT8"}) {
            double number = type.startsWith("U") ? 200 : -2;
            of(type).put(number, values, 0);
            Channel channel = new Channel(
                    Channel.Semantic.CUSTOM,
                    "x",
                    1,
                    of(type).type(),
                    type.equals("FLOAT64") ? values : new int[] {values[0]},
                    null);
            assertThat(channel.exact(0, 0)).as(type).isEqualTo(number);
        }
    }
}

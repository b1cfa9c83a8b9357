package org.dronemap.mavlink.generator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class DefinitionReaderTest {
    @TempDir
    private Path folder;

    private List<MessageDefinition> read(String text) throws IOException {
        return DefinitionReader.read(Files.writeString(folder.resolve("definitions.txt"), text));
    }

    @Test
    void readsFieldsInTheOrderOfTheDefinition() throws IOException {
        List<MessageDefinition> read = read(
                "# a note\n\n0 HEARTBEAT\n    uint8_t type\n    uint32_t custom_mode\n\n4 PING\n    uint32_t seq\n");

        assertThat(read).extracting(MessageDefinition::recordName).containsExactly("Heartbeat", "Ping");
        assertThat(read.get(0).fields())
                .containsExactly(
                        new MessageField(FieldType.UINT8, 0, "type", false),
                        new MessageField(FieldType.UINT32, 0, "custom_mode", false));
    }

    @Test
    void placesTheLargestFirstAndExtensionsAfterAll() throws IOException {
        MessageDefinition message =
                read("1 ONE\n    uint8_t a\n    uint16_t[2] b\n    extensions\n    uint8_t c\n    uint64_t d\n")
                        .get(0);

        assertThat(message.wireOrder())
                .extracting(place -> place.field().name() + " " + place.offset())
                .containsExactly("b 0", "a 4", "c 5", "d 6");
        assertThat(message.shortestPayload()).isEqualTo(5);
        assertThat(message.longestPayload()).isEqualTo(14);
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', ignoreLeadingAndTrailingWhitespace = false, textBlock = """
            1 ONE;    uint9_t a|line 2: the type of a field is one of char, int8_t, uint8_t, int16_t, uint16_t, int32_t, uint32_t, int64_t, uint64_t, float, double, not uint9_t
            1 ONE;  uint8_t a|line 2: wanted "NUMBER NAME" of a message, or after it "    TYPE name" or "    TYPE[ELEMENTS] name" of a field or "    extensions", not "  uint8_t a"
            1 ONE;2 ONE|line 2: the number 2 or the name ONE was there before
            1 ONE;1 TWO|line 2: the number 1 or the name TWO was there before
            1 ONE;    uint8_t a;    float a|line 3: ONE had a field a before
            1 ONE;    uint8_t a;    double[32] b|line 3: ONE has at most 255 octets, not 257
            """)
    void saysWhatIsNoDefinition(String text, String sentence) {
        assertThatThrownBy(() -> read(text.replace(';', '\n'))).hasMessageEndingWith("definitions.txt, " + sentence);
    }

    @ParameterizedTest
    @ValueSource(strings = {"    uint8_t a", "    extensions"})
    void wantsAMessageBeforeItsFields(String line) {
        assertThatThrownBy(() -> read(line)).hasMessageContaining("line 1: wanted \"NUMBER NAME\" of a message");
    }
}

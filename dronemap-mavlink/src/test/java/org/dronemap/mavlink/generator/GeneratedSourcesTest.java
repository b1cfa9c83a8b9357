package org.dronemap.mavlink.generator;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.dronemap.mavlink.MessageTable;
import org.junit.jupiter.api.Test;

/** What is committed is what the generator writes, so that no field offset is ever changed by hand. */
class GeneratedSourcesTest {
    @Test
    void tableEqualsTheDefinitions() throws IOException {
        assertThat(Path.of("src/main/resources/org/dronemap/mavlink/messages.tsv"))
                .content()
                .isEqualTo(MessageGenerator.table(Definitions.all()));
    }

    @Test
    void newerTableHoldsOnlyWhatDronefleetLacks() throws IOException {
        Map<Integer, Class<?>> definitions = Definitions.all();
        assertThat(Files.readAllLines(Path.of("src/main/resources/org/dronemap/mavlink/messages-newer.tsv")))
                .filteredOn(line -> !line.startsWith("#"))
                .isNotEmpty()
                .noneMatch(line -> definitions.containsKey(Integer.parseInt(line.split("\t", -1)[0])));
        assertThat(MessageTable.find(53)).isEqualTo(new MessageTable.Entry(53, "MissionChecksum", 3, 5, 5, -1));
    }

    @Test
    void recordsEqualTheDefinitionsButForTheirLayout() throws IOException {
        for (String name : MessageGenerator.MESSAGES) {
            Path source = Path.of("src/main/java/org/dronemap/mavlink/message", name + ".java");
            assertThat(withoutLayout(Files.readString(source)))
                    .isEqualTo(withoutLayout(MessageSources.source(OracleMessages.type(name))));
        }
    }

    private static String withoutLayout(String source) {
        return source.replaceAll("\\s+", "");
    }
}

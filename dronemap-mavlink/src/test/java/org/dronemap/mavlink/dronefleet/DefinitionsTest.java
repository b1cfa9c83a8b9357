package org.dronemap.mavlink.dronefleet;

import static org.assertj.core.api.Assertions.assertThat;

import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.dronemap.mavlink.MessageTable;
import org.dronemap.mavlink.generator.MessageDefinition;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What is defined here is what dronefleet knows, which has it from MAVLink itself. */
class DefinitionsTest {
    private static final Path TABLE = Path.of("src/main/resources/org/dronemap/mavlink/messages.tsv");

    static Stream<MessageDefinition> definitions() {
        return OracleMessages.DEFINITIONS.values().stream();
    }

    @ParameterizedTest
    @MethodSource("definitions")
    void definesAMessageAsTheTableOfAllHasIt(MessageDefinition message) {
        int target = message.wireOrder().stream()
                .filter(place -> place.field().name().equals("target_system"))
                .mapToInt(MessageDefinition.Place::offset)
                .findFirst()
                .orElse(-1);

        assertThat(MessageTable.find(message.id()))
                .isEqualTo(new MessageTable.Entry(
                        message.id(),
                        message.recordName(),
                        message.checksumSeed(),
                        message.shortestPayload(),
                        message.longestPayload(),
                        target));
    }

    @ParameterizedTest
    @MethodSource("definitions")
    void hasEachFieldWhereDronefleetHasIt(MessageDefinition message) {
        List<OracleMessages.Place> here = message.wireOrder().stream()
                .map(place -> new OracleMessages.Place(
                        place.field().javaName(), place.offset(), place.field().length()))
                .toList();

        assertThat(here).isEqualTo(OracleMessages.places(message.recordName()));
    }

    /** The table of all messages, which is for those that are only passed on, is written from dronefleet's. */
    @Test
    void tableIsDronefleets() throws IOException {
        String table = table(DronefleetMessages.all());
        if (Boolean.getBoolean("dronemap.approve")) {
            Files.writeString(TABLE, table);
        }

        assertThat(TABLE).content().isEqualTo(table);
    }

    @Test
    void newerTableHoldsOnlyWhatDronefleetLacks() throws IOException {
        Map<Integer, Class<?>> messages = DronefleetMessages.all();
        assertThat(Files.readAllLines(TABLE.resolveSibling("messages-newer.tsv")))
                .filteredOn(line -> !line.startsWith("#"))
                .isNotEmpty()
                .noneMatch(line -> messages.containsKey(Integer.parseInt(line.split("\t", -1)[0])));
        assertThat(MessageTable.find(53)).isEqualTo(new MessageTable.Entry(53, "MissionChecksum", 3, 5, 5, -1));
    }

    private static String table(Map<Integer, Class<?>> messages) {
        StringBuilder table = new StringBuilder(
                "# id\tname\tchecksum seed\tshortest payload\tlongest payload\toffset of target system\n");
        messages.forEach((id, type) -> table.append(id)
                .append('\t')
                .append(type.getSimpleName())
                .append('\t')
                .append(type.getAnnotation(MavlinkMessageInfo.class).crc())
                .append('\t')
                .append(DronefleetLayout.lengthWithoutExtensions(type))
                .append('\t')
                .append(DronefleetLayout.length(type))
                .append('\t')
                .append(DronefleetLayout.targetSystemOffset(type))
                .append('\n'));
        return table.toString();
    }
}

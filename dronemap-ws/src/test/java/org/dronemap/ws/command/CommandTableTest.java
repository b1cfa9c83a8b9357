package org.dronemap.ws.command;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.drone.Capability;
import org.dronemap.ws.reading.RecordAlternatives;
import org.dronemap.ws.reading.WireNames;
import org.dronemap.ws.testserver.GeneratedSection;
import org.junit.jupiter.api.Test;

/** The table of commands in docs/security.md says what their kinds say; that the gate keeps to it is tried elsewhere. */
class CommandTableTest {
    private static final String HEAD = "| operation | from | without control of the drone |\n| --- | --- | --- |\n";

    @Test
    void isTheTableOfThePage() throws IOException {
        RecordAlternatives bodies = RecordAlternatives.of(CommandRequest.class).orElseThrow();
        GeneratedSection.check(
                Path.of("..", "docs", "security.md"),
                "the kinds of commands",
                Stream.of(CommandKind.values())
                        .filter(kind -> bodies.records().containsKey(WireNames.lowerFirst(kind.word())))
                        .sorted(Comparator.comparing(kind -> kind.needs().part()))
                        .map(CommandTableTest::row)
                        .collect(Collectors.joining("", HEAD, "")));
    }

    private static String row(CommandKind kind) {
        boolean prepares = kind.needs().part() == Capability.Part.PREPARES;
        String without = switch (kind.purpose()) {
            case READ -> "yes";
            case SAFETY, PAUSE -> "supervisor";
            case FLY, CHANGE -> "no";
        };
        return "| `" + WireNames.lowerFirst(kind.word()) + "` | "
                + (prepares ? "planner, while the drone is known to be disarmed" : "operator") + " | " + without
                + " |\n";
    }
}

package org.dronemap.mavlink.generator;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class MessageGeneratorTest {
    private static final FileTime LONG_AGO = FileTime.from(Instant.EPOCH);
    private static final String PING = "4 PING\n    uint64_t time_usec\n    uint32_t seq\n";
    private static final String TEXT = "253 STATUSTEXT\n    char[50] text\n    extensions\n    uint8_t[4] raw\n";

    @TempDir
    private Path folder;

    private Path definitions;
    private Path sources;
    private Path records;

    @BeforeEach
    void place() {
        definitions = folder.resolve("definitions.txt");
        sources = folder.resolve("sources");
        records = sources.resolve("org/dronemap/mavlink/message");
    }

    private void generate(String text) throws IOException {
        Files.writeString(definitions, text);
        MessageGenerator.main(new String[] {definitions.toString(), sources.toString()});
    }

    @Test
    void writesTheRecordOfEachMessage() throws IOException {
        generate(PING + TEXT);

        assertThat(records.resolve("Ping.java"))
                .content()
                .contains("public record Ping(long timeUsec, long seq) implements Message {")
                .contains("return new Ping(frame.i64(0), frame.u32(8));");
        assertThat(records.resolve("Statustext.java"))
                .content()
                .contains(
                        "@SuppressWarnings(\"ArrayRecordComponent\")\npublic record Statustext(String text, int[] raw)")
                .contains("        out.text(text, 50);\n        out.u8s(raw, 4);\n");
    }

    @Test
    void touchesNothingThatIsAsItShouldBe() throws IOException {
        generate(PING + TEXT);
        for (String name : List.of("Ping.java", "Statustext.java")) {
            Files.setLastModifiedTime(records.resolve(name), LONG_AGO);
        }

        generate(PING + TEXT.replace("[50]", "[40]"));

        assertThat(Files.getLastModifiedTime(records.resolve("Ping.java"))).isEqualTo(LONG_AGO);
        assertThat(Files.getLastModifiedTime(records.resolve("Statustext.java")))
                .isGreaterThan(LONG_AGO);
    }

    @Test
    void removesWhatIsDefinedNoLonger() throws IOException {
        generate(PING + TEXT);
        generate(TEXT);

        assertThat(records).isDirectoryContaining("glob:**/Statustext.java");
        assertThat(records).isDirectoryNotContaining("glob:**/Ping.java");
    }

    @Test
    void wantsAFileAndAFolder() {
        assertThatThrownBy(() -> MessageGenerator.main(new String[0]))
                .hasMessage("wanted the file of definitions and the folder of sources, not 0 arguments");
    }
}

package org.dronemap.proxy.outlet.uplink;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The commands that the guide says pass are those that pass. */
class ClientCommandGuideTest {
    private static final Pattern COMMAND = Pattern.compile("\\| (\\d+) `([A-Z0-9_]+)` \\| (.+) \\|");

    @Test
    void theGuideListsTheCommandsThatPass() throws IOException {
        Map<Integer, String> listed = new LinkedHashMap<>();
        Matcher rows = COMMAND.matcher(Files.readString(Path.of("../docs/outlet.md")));
        while (rows.find()) {
            listed.put(Integer.parseInt(rows.group(1)), rows.group(2) + ": " + rows.group(3));
        }
        assertThat(listed).isEqualTo(ClientCommandReader.table());
    }
}

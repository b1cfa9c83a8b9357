package org.dronemap.proxy.outlet.client;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.dronemap.mavlink.MessageTable;
import org.junit.jupiter.api.Test;

/** The messages of vehicles that the guide says are for the cloud alone are those. */
class ClientMessageGuideTest {
    @Test
    void theGuideListsWhatVehiclesSayToTheCloudAlone() throws IOException {
        String guide = Files.readString(Path.of("../docs/outlet.md"));
        String table = guide.substring(guide.indexOf("### From vehicles"), guide.indexOf("### From clients"));
        TreeSet<Integer> hidden = new TreeSet<>();
        IntStream.rangeClosed(0, 512)
                .filter(id -> MessageTable.find(id) != null && isNamed(table, name(id)))
                .filter(id -> id != 42 && id != 46)
                .forEach(hidden::add);
        TreeSet<Integer> inCode = new TreeSet<>(ClientMessageFilter.ENDS_IN_THE_CLOUD);
        inCode.removeIf(id -> MessageTable.find(id) == null);
        assertThat(hidden).isEqualTo(inCode);
    }

    /** By its own name, or by one that stands for all that begin so. */
    private static boolean isNamed(String table, String name) {
        if (table.contains("`" + name + "`")) {
            return true;
        }
        Matcher families = Pattern.compile("`([A-Z_]+_)\\*`").matcher(table);
        while (families.find()) {
            if (name.startsWith(families.group(1))) {
                return true;
            }
        }
        return false;
    }

    private static String name(int id) {
        MessageTable.Entry entry = MessageTable.find(id);
        return entry == null
                ? ""
                : entry.name().replaceAll("(?<=[a-z0-9])(?=[A-Z])", "_").toUpperCase(Locale.ROOT);
    }
}

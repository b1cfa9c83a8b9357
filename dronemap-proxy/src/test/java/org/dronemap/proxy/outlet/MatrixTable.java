package org.dronemap.proxy.outlet;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.IntStream;
import org.dronemap.mavlink.MessageTable;

/** The committed table of what reaches a vehicle's socket: a row for each message and each command, a column for each sender. */
final class MatrixTable {
    static final List<String> COLUMNS = List.of(
            "stranger",
            "viewer",
            "planner",
            "operator without control",
            "operator with control",
            "operator with control at a personal port");
    private static final Path FILE = Path.of("src/test/resources/org/dronemap/proxy/outlet/what-reaches-vehicles.md");
    private static final Path SEEN = Path.of("target/what-was-seen");
    private static final Pattern ROW = Pattern.compile("\\| (message|command) (\\d+) `(\\w+)` \\|(.*)\\|");
    private static final int HIGHEST_ID = 100_000;

    private final Map<Row, List<String>> rows = new LinkedHashMap<>();

    /** {@code kind} is message or command. */
    record Row(String kind, int number, String name) {}

    MatrixTable() throws IOException {
        for (String line : Files.readAllLines(FILE)) {
            Matcher row = ROW.matcher(line);
            if (row.matches()) {
                List<String> cells = List.of(row.group(4).split("\\|", -1)).stream()
                        .map(String::strip)
                        .toList();
                rows.put(new Row(row.group(1), Integer.parseInt(row.group(2)), row.group(3)), cells);
            }
        }
    }

    List<Row> rows() {
        return List.copyOf(rows.keySet());
    }

    /** Nothing: an empty cell. */
    Map<Row, String> column(String name) {
        Map<Row, String> column = new LinkedHashMap<>();
        rows.forEach((row, cells) -> column.put(row, cells.get(COLUMNS.indexOf(name))));
        return column;
    }

    /** Leaves what was seen where the build leaves its things, for whoever looks into a difference. */
    static void leave(String column, Map<Row, String> seen) throws IOException {
        Files.createDirectories(SEEN);
        List<String> lines = seen.entrySet().stream()
                .map(cell -> cell.getKey().kind() + " " + cell.getKey().number() + "\t" + cell.getValue())
                .toList();
        Files.write(SEEN.resolve(column + ".tsv"), lines);
    }

    static String cell(Set<String> reached) {
        return String.join(", ", reached);
    }

    /** Each message that is known here. */
    static Map<Integer, MessageTable.Entry> messages() {
        Map<Integer, MessageTable.Entry> messages = new TreeMap<>();
        IntStream.range(0, HIGHEST_ID)
                .mapToObj(MessageTable::find)
                .filter(entry -> entry != null)
                .forEach(entry -> messages.put(entry.id(), entry));
        return messages;
    }

    /** As MAVLink writes it. */
    static String name(MessageTable.Entry entry) {
        return entry.name().replaceAll("(?<=[a-z0-9])(?=[A-Z])", "_").toUpperCase(Locale.ROOT);
    }
}

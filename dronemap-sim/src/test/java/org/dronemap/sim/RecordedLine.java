package org.dronemap.sim;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;

/** One line of a recording: a flat JSON object. */
record RecordedLine(Map<String, String> fields) {
    private static final Path EXCHANGES = Path.of("exchanges");
    private static final Pattern FIELD = Pattern.compile("\"(\\w+)\": (?:\"([^\"]*)\"|([^,}\\[]+))");

    static List<RecordedLine> read(String exchange) {
        return readFile("recorded/" + exchange);
    }

    /** A file among the exchanges, its name without the ending. */
    static List<RecordedLine> readFile(String name) {
        try {
            return parse(Files.readAllLines(EXCHANGES.resolve(name + ".jsonl")));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static List<RecordedLine> parse(List<String> lines) {
        return lines.stream().map(RecordedLine::parse).toList();
    }

    boolean isSaid() {
        return text("dir").equals("to");
    }

    boolean is(String message) {
        return text("msg").equals(message);
    }

    long millis() {
        return integer("t_ms");
    }

    private static RecordedLine parse(String line) {
        Map<String, String> fields = new HashMap<>();
        var matcher = FIELD.matcher(line);
        while (matcher.find()) {
            fields.put(matcher.group(1), matcher.group(2) != null ? matcher.group(2) : matcher.group(3));
        }
        return new RecordedLine(fields);
    }

    String text(String name) {
        return fields.getOrDefault(name, "");
    }

    long integer(String name) {
        return (long) Double.parseDouble(fields.get(name));
    }

    float number(String name) {
        String value = fields.getOrDefault(name, "0");
        return value.equals("null") ? Float.NaN : Float.parseFloat(value);
    }
}

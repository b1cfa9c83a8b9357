package org.dronemap.ws.testserver;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dronemap.core.access.Role;

/** What docs/security.md promises: for each operation from whom on it is open. */
public final class RightsTable {
    private static final Path PAGE = Path.of("..", "docs", "security.md");
    private static final Pattern ROW = Pattern.compile("\\| `([^`]+)` \\| ([a-z ]+?)(?:, [^|]*)? \\|.*");

    private final Map<String, Integer> firstRank = new LinkedHashMap<>();

    private RightsTable() {}

    /** The table below the heading. */
    public static RightsTable below(String heading) {
        RightsTable table = new RightsTable();
        boolean inside = false;
        for (String line : lines()) {
            if (line.startsWith("#")) {
                inside = line.equals("### " + heading);
            }
            Matcher row = ROW.matcher(line);
            if (inside && row.matches()) {
                table.firstRank.put(row.group(1), rank(row.group(2)));
            }
        }
        return table;
    }

    private static Iterable<String> lines() {
        try {
            return Files.readAllLines(PAGE);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static int rank(String from) {
        return switch (from) {
            case "anybody" -> Caller.NOBODY.ordinal();
            case "signed in" -> Caller.REPORTER.ordinal();
            default -> Caller.valueOf(from.toUpperCase(Locale.ROOT)).ordinal();
        };
    }

    public Iterable<String> operations() {
        return firstRank.keySet();
    }

    public boolean lists(String operation) {
        return firstRank.containsKey(operation);
    }

    /** The least role that an operation is open to; a viewer for what is open to all who may look. */
    public Role least(String operation) {
        int first =
                Math.max(Caller.VIEWER.ordinal(), firstRank.getOrDefault(operation, Caller.ADMINISTRATOR.ordinal()));
        return Role.valueOf(Caller.values()[first].name());
    }

    public boolean promises(String operation, Caller caller) {
        Integer first = firstRank.get(operation);
        return first != null && caller.ordinal() >= first;
    }

    /** Everybody that the tables tell apart, least first. */
    public enum Caller {
        NOBODY,
        REPORTER,
        VIEWER,
        PLANNER,
        OPERATOR,
        SUPERVISOR,
        ADMINISTRATOR;

        /** A key of such a user; empty for nobody. */
        public String key(TestServer house) {
            return Arrays.stream(Role.values())
                    .filter(role -> role.name().equals(name()))
                    .findFirst()
                    .map(house::key)
                    .orElse("");
        }
    }
}

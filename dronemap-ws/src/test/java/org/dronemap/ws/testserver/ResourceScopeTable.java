package org.dronemap.ws.testserver;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** What docs/security.md says that the operations of REST are about. */
public final class ResourceScopeTable {
    private static final Path PAGE = Path.of("..", "docs", "security.md");
    private static final Pattern ROW = Pattern.compile("\\| `([A-Z]+ /[^`]+)` \\| [a-z ]+ \\| ([a-z]+) \\|.*");

    private final Map<String, Whose> rows = new LinkedHashMap<>();

    /** About what an operation is. */
    public enum Whose {
        DRONE,
        ORGANISATION,
        SHARED,
        SERVER,
        OWN,
        NONE
    }

    public ResourceScopeTable() {
        boolean inside = false;
        try {
            for (String line : Files.readAllLines(PAGE)) {
                if (line.startsWith("#")) {
                    inside = line.equals("### REST");
                }
                Matcher row = ROW.matcher(line);
                if (inside && row.matches()) {
                    rows.put(row.group(1), Whose.valueOf(row.group(2).toUpperCase(Locale.ROOT)));
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** Of an operation such as {@code GET /api/v1/drones/{id}}; empty when no row has it. */
    public Optional<Whose> of(String operation) {
        return Optional.ofNullable(rows.get(operation));
    }
}

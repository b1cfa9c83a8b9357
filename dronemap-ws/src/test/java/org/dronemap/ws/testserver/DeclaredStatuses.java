package org.dronemap.ws.testserver;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Holds each answer of REST that any test gets against the statuses that the description lists for its operation. */
public final class DeclaredStatuses {
    private static final Path DESCRIPTION = Path.of("src", "test", "resources", "wire", "openapi.json");
    private static final List<Listed> ALL = read();

    private DeclaredStatuses() {}

    private record Listed(String method, String path, Pattern pattern, Set<Integer> statuses) {}

    private static List<Listed> read() {
        JsonNode description;
        try {
            description = new JsonMapper().readTree(Files.readString(DESCRIPTION));
        } catch (IOException e) {
            throw new IllegalStateException(e);
        }
        List<Listed> all = new ArrayList<>();
        description
                .path("paths")
                .forEachEntry((path, operations) -> operations.forEachEntry((method, operation) -> {
                    Set<Integer> statuses = new TreeSet<>();
                    operation
                            .path("responses")
                            .propertyNames()
                            .forEach(status -> statuses.add(Integer.valueOf(status)));
                    Pattern pattern = Pattern.compile(path.replaceAll("\\{[^/]+}", "[^/]+"));
                    all.add(new Listed(method.toUpperCase(Locale.ROOT), path, pattern, statuses));
                }));
        // What is written out goes before what stands for anything.
        all.sort(Comparator.comparingInt(one -> one.path().split("\\{", -1).length));
        return all;
    }

    /** {@code path}: without its query. */
    public static void check(String method, String path, int status) {
        StatusRecordingValve.seen(method, path, status);
        find(method, path).filter(one -> !one.statuses().contains(status)).ifPresent(one -> {
            throw new AssertionError("The description of " + method + " " + one.path() + " lists " + one.statuses()
                    + ", and not " + status + ", with which it answered.");
        });
    }

    /** Method and address as the description has them; empty: it has no such operation. {@code path}: without its query. */
    static Optional<String> operation(String method, String path) {
        return find(method, path).map(one -> one.method() + " " + one.path());
    }

    private static Optional<Listed> find(String method, String path) {
        return ALL.stream()
                .filter(one -> one.method().equals(method)
                        && one.pattern().matcher(path).matches())
                .findFirst();
    }
}

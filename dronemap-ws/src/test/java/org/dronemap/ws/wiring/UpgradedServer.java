package org.dronemap.ws.wiring;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import java.util.zip.ZipFile;
import org.dronemap.core.operation.SavedOperation;
import org.dronemap.core.time.SteppedTime;
import org.dronemap.core.virtual.VirtualDrone;
import org.dronemap.store.postgres.PostgresStores;
import org.dronemap.ws.server.MaintenanceTasks;
import org.dronemap.ws.server.ServerComponents;
import org.dronemap.ws.server.ShutdownSequence;
import org.dronemap.ws.settings.ServerSettings;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * What an earlier version has stored, restored as the script does it and taken up by a server of now, half a minute later;
 * nobody calls in.
 */
final class UpgradedServer implements AutoCloseable {
    private static final Path VERSIONS = Path.of("src/test/resources/upgrades");
    private static final Duration LATER = Duration.ofSeconds(30);

    private final Path version;
    private final Path data;
    private final SteppedTime time;
    private final PostgresStores database;
    private final List<SavedOperation> underWay;
    private final List<VirtualDrone> virtuals;
    private final SteppedServer server;

    UpgradedServer(Path version, Path data) {
        this.version = version;
        this.data = data;
        copy(version.resolve("data"), data);
        time = new SteppedTime(
                Instant.parse(facts().required("moment").stringValue()).plus(LATER));
        ownerTask("--restore", backup().toString());
        database = PostgresStores.openOwn(data.resolve("postgres"));
        try {
            underWay = database.operations().underWay();
            virtuals = database.virtualDrones().virtualDrones();
            server = new SteppedServer(settings(), time, database);
        } catch (RuntimeException unreadable) {
            database.close();
            throw unreadable;
        }
        time.settle();
    }

    /** Each by the day on which it was stored. */
    static Stream<Path> versions() {
        try (Stream<Path> all = Files.list(VERSIONS)) {
            return all.filter(Files::isDirectory).sorted().toList().stream();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private int ownerTask(String... arguments) {
        ShutdownSequence closing = new ShutdownSequence();
        try {
            return new MaintenanceTasks(settings(), closing, time).run(List.of(arguments));
        } finally {
            closing.close();
        }
    }

    ServerSettings settings() {
        return SteppedServer.settings(data, null, null);
    }

    Path backup() {
        return version.resolve("backup.zip");
    }

    Path receipt() {
        return version.resolve("receipt.json");
    }

    Path data() {
        return data;
    }

    JsonNode facts() {
        return json(read(version.resolve("facts.json")));
    }

    boolean hasTable(String table) {
        return table(table).isPresent();
    }

    boolean hasColumn(String table, String column) {
        return table(table)
                .filter(one -> one.required("columns")
                        .valueStream()
                        .anyMatch(name -> name.stringValue().equals(column)))
                .isPresent();
    }

    /** That were stored in that table. */
    long rows(String table) {
        return table(table)
                .orElseThrow(() -> new IllegalArgumentException("there was no table " + table))
                .required("rows")
                .longValue();
    }

    private Optional<JsonNode> table(String table) {
        try (ZipFile zip = new ZipFile(backup().toFile())) {
            String manifest =
                    new String(zip.getInputStream(zip.getEntry("manifest.json")).readAllBytes(), UTF_8);
            return json(manifest)
                    .required("tables")
                    .valueStream()
                    .filter(one -> one.required("name").stringValue().equals(table))
                    .findFirst();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    SteppedTime time() {
        return time;
    }

    PostgresStores database() {
        return database;
    }

    /** As they were stored. */
    List<SavedOperation> underWay() {
        return underWay;
    }

    /** As they were stored. */
    List<VirtualDrone> virtuals() {
        return virtuals;
    }

    SteppedServer server() {
        return server;
    }

    ServerComponents house() {
        return server.house();
    }

    static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static JsonNode json(String text) {
        return JsonMapper.shared().readTree(text);
    }

    private static void copy(Path from, Path to) {
        try (Stream<Path> all = Files.walk(from)) {
            for (Path path : all.toList()) {
                Path copy = to.resolve(from.relativize(path).toString());
                if (Files.isDirectory(path)) {
                    Files.createDirectories(copy);
                } else {
                    Files.copy(path, copy);
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public void close() {
        server.close();
        database.close();
    }
}

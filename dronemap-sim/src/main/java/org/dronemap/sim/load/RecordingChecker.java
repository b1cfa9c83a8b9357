package org.dronemap.sim.load;

import java.io.BufferedInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.tlog.TlogReader;

/**
 * Load test: checks recordings byte for byte against all frames that the load vehicles sent. What came behind later
 * news is late.
 */
final class RecordingChecker {
    private static final int CLOUD = 255;
    private static final int FAREWELLS = 3;

    private final Path folder;
    private final int vehicles;
    private final int perSecond;
    private final int steps;
    private final boolean onlyPositions;
    private final Set<Integer> seen = new HashSet<>();
    private long files;
    private long found;
    private long late;
    private long foreign;
    private long down;
    private long broken;

    RecordingChecker(LoadArguments arguments) {
        folder = Path.of(arguments.text("--folder"));
        vehicles = arguments.integer("--vehicles");
        perSecond = arguments.integer("--rate");
        steps = arguments.integer("--steps");
        onlyPositions = arguments.text("--only-positions", "no").equals("yes");
    }

    String run() throws IOException {
        List<Path> recordings;
        try (Stream<Path> listed = Files.list(folder)) {
            recordings = listed.filter(file -> file.toString().endsWith(".tlog"))
                    .sorted()
                    .toList();
        }
        for (Path recording : recordings) {
            check(recording);
        }
        long expected = (long) vehicles * (steps + FAREWELLS);
        return "{\"files\":" + files + ",\"vehicles\":" + seen.size() + ",\"expected\":" + expected + ",\"found\":"
                + found + ",\"missing\":" + (expected - found) + ",\"late\":" + late + ",\"foreign\":" + foreign
                + ",\"brokenBytes\":"
                + broken + ",\"down\":" + down + "}";
    }

    private void check(Path recording) throws IOException {
        files++;
        List<Frame> up = new ArrayList<>();
        try (InputStream in = new BufferedInputStream(Files.newInputStream(recording))) {
            TlogReader reader = new TlogReader(in);
            for (TlogReader.Timed record = reader.next(); record != null; record = reader.next()) {
                if (record.frame().systemId() == CLOUD) {
                    down++;
                } else {
                    up.add(record.frame());
                }
            }
            broken += reader.counts().brokenBytes();
        }
        OptionalInt vehicle = vehicle(up);
        if (vehicle.isEmpty()) {
            foreign += up.size();
        } else {
            seen.add(vehicle.getAsInt());
            compare(up, expected(vehicle.getAsInt()));
        }
    }

    private OptionalInt vehicle(List<Frame> frames) {
        return frames.stream()
                .filter(frame -> frame.messageId() == GlobalPositionInt.ID)
                .mapToInt(frame ->
                        (GlobalPositionInt.decode(frame).lon() - LoadFrames.LONGITUDE_E7) / LoadFrames.VEHICLE_E7)
                .filter(vehicle -> vehicle >= 0 && vehicle < vehicles)
                .findFirst();
    }

    private List<byte[]> expected(int vehicle) {
        LoadFrames frames = new LoadFrames(vehicle, perSecond, onlyPositions);
        List<byte[]> all = new ArrayList<>(steps + FAREWELLS);
        for (int step = 0; step < steps; step++) {
            all.add(frames.next());
        }
        for (int again = 0; again < FAREWELLS; again++) {
            all.add(frames.disarmed());
        }
        return all;
    }

    private void compare(List<Frame> heard, List<byte[]> said) {
        Map<ByteBuffer, TreeSet<Integer>> places = new HashMap<>();
        for (int at = 0; at < said.size(); at++) {
            places.computeIfAbsent(ByteBuffer.wrap(said.get(at)), bytes -> new TreeSet<>())
                    .add(at);
        }
        int next = 0;
        for (Frame frame : heard) {
            TreeSet<Integer> open = places.get(ByteBuffer.wrap(frame.bytes()));
            if (open == null || open.isEmpty()) {
                foreign++;
                continue;
            }
            Integer ahead = open.ceiling(next);
            int at = ahead == null ? open.first() : ahead;
            open.remove(at);
            found++;
            if (at < next) {
                late++;
            } else {
                next = at + 1;
            }
        }
    }
}

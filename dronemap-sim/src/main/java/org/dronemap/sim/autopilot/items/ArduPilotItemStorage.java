package org.dronemap.sim.autopilot.items;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dronemap.sim.flight.SimulatedMissionItem;
import org.jspecify.annotations.Nullable;

/**
 * Stores mission items as ArduPilot does: what its table does not list is refused, and of the rest only what fits into
 * its few bytes an item is kept, without a word.
 */
public final class ArduPilotItemStorage implements MissionItemStorage {
    private static final String TABLE = "ardupilot.txt";
    private static final int JUMP = 177;
    private static final int PLACE_COLUMN = 4;
    private static final int MAX_LATITUDE = 900_000_000;
    private static final int MAX_LONGITUDE = 1_800_000_000;
    private static final float MAX_METERS = 83_000;
    private static final int FRAME_RELATIVE = 3;
    private static final int FRAME_TERRAIN = 10;

    /** The kept parts of a command: four parameters, then x, y and z when they are no place. */
    private record Kept(boolean place, List<KeptNumber> numbers) {
        KeptNumber number(int index) {
            return numbers.get(index);
        }
    }

    private final Map<Integer, Kept> table = new TreeMap<>();

    private ArduPilotItemStorage(String vehicle) {
        List<String> rows = read().lines()
                .filter(line -> !line.isBlank() && !line.startsWith("#"))
                .toList();
        for (String row : rows) {
            String[] words = row.split(" ", -1);
            if (words[1].equals("all") || List.of(words[1].split(",", -1)).contains(vehicle)) {
                table.putIfAbsent(Integer.parseInt(words[0]), kept(Arrays.copyOfRange(words, 2, words.length)));
            }
        }
    }

    /** Of {@code copter}, {@code plane} or {@code rover}. */
    public static ArduPilotItemStorage of(String vehicle) {
        if (!List.of("copter", "plane", "rover").contains(vehicle)) {
            throw new IllegalArgumentException("the table of mission items knows no vehicle called '" + vehicle + "'");
        }
        return new ArduPilotItemStorage(vehicle);
    }

    private static String read() {
        try (InputStream table = ArduPilotItemStorage.class.getResourceAsStream(TABLE)) {
            if (table == null) {
                throw new IllegalStateException("the table of mission items, " + TABLE + ", is missing");
            }
            return new String(table.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException("the table of mission items, " + TABLE + ", cannot be read", e);
        }
    }

    private static Kept kept(String[] words) {
        boolean place = words[PLACE_COLUMN].equals("place");
        return new Kept(
                place,
                Arrays.stream(words)
                        .limit(place ? PLACE_COLUMN : words.length)
                        .map(KeptNumber::of)
                        .toList());
    }

    @Override
    public int judge(SimulatedMissionItem sent, int last) {
        Kept kept = table.get(sent.command());
        float[] parameters = {sent.param1(), sent.param2(), sent.param3(), sent.param4()};
        for (int i = 0; i < parameters.length; i++) {
            boolean taken = kept == null
                    ? Float.isFinite(parameters[i])
                    : kept.number(i).accepts(parameters[i]);
            if (!taken) {
                return INVALID_PARAM1 + i;
            }
        }
        if (kept == null) {
            return UNSUPPORTED;
        }
        if (sent.command() == JUMP && (sent.param1() < 1 || sent.param1() > last)) {
            return ERROR;
        }
        return kept.place() ? judgePlace(sent) : ACCEPTED;
    }

    private static int judgePlace(SimulatedMissionItem sent) {
        if (Math.abs((long) sent.x()) > MAX_LATITUDE) {
            return INVALID_PARAM5;
        }
        if (Math.abs((long) sent.y()) > MAX_LONGITUDE) {
            return INVALID_PARAM6;
        }
        if (!(Math.abs(sent.z()) < MAX_METERS)) {
            return INVALID_PARAM7;
        }
        return keptFrame(sent.frame()) == null ? UNSUPPORTED_FRAME : ACCEPTED;
    }

    /** The frames that mean the same read back as one; a place "in no frame" is taken as above sea level. */
    private static @Nullable Integer keptFrame(int frame) {
        return switch (frame) {
            case 0, 2, 5 -> SimulatedMissionItem.FRAME_AMSL;
            case FRAME_RELATIVE, 6 -> FRAME_RELATIVE;
            case FRAME_TERRAIN, 11 -> FRAME_TERRAIN;
            default -> null;
        };
    }

    @Override
    public SimulatedMissionItem keep(SimulatedMissionItem sent) {
        Kept kept = table.get(sent.command());
        Integer frame = keptFrame(sent.frame());
        if (kept == null || (kept.place() && frame == null)) {
            throw new IllegalArgumentException("item of command " + sent.command() + " is not one that is stored");
        }
        return new SimulatedMissionItem(
                sent.command(),
                kept.place() && frame != null ? frame : SimulatedMissionItem.FRAME_AMSL,
                1,
                (float) kept.number(0).keep(sent.param1()),
                (float) kept.number(1).keep(sent.param2()),
                (float) kept.number(2).keep(sent.param3()),
                (float) kept.number(3).keep(sent.param4()),
                kept.place() ? sent.x() : (int) kept.number(4).keep(sent.x()),
                kept.place() ? sent.y() : (int) kept.number(5).keep(sent.y()),
                kept.place()
                        ? (int) (sent.z() * 100) / 100f
                        : (float) kept.number(6).keep(sent.z()));
    }
}

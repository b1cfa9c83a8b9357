package org.dronemap.archive;

import java.io.IOException;
import java.time.LocalDate;
import java.time.ZoneOffset;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dronemap.core.history.TelemetryColumn;
import org.jspecify.annotations.Nullable;

/** Rows of some drones over one day, many facts among them not known; the same each time, unless told otherwise. */
final class SimulatedRowSource implements RowSource {
    static final LocalDate DAY = LocalDate.of(2026, 3, 4);
    private static final int DRONES = 5;
    private static final int SECONDS_APART = 40;

    private final List<List<@Nullable Object>> rows = new ArrayList<>();
    private int failAfter = Integer.MAX_VALUE;
    private int wrongFrom = Integer.MAX_VALUE;
    private int passes;

    SimulatedRowSource() {
        long begin = DAY.atStartOfDay().toEpochSecond(ZoneOffset.UTC);
        Random random = new Random(42);
        for (int drone = 0; drone < DRONES; drone++) {
            for (int second = 0; second < 86_400; second += SECONDS_APART) {
                rows.add(row("copter-" + drone, (begin + second) * 1_000_000 + random.nextInt(1_000_000), random));
            }
        }
    }

    private static List<@Nullable Object> row(String drone, long at, Random random) {
        List<@Nullable Object> row = new ArrayList<>();
        for (TelemetryColumn column : TelemetryColumn.ALL) {
            row.add(column.required() || random.nextInt(4) > 0 ? value(column, drone, at, random) : null);
        }
        return row;
    }

    private static Object value(TelemetryColumn column, String drone, long at, Random random) {
        return switch (column.kind()) {
            case TEXT -> column == TelemetryColumn.DRONE_ID ? drone : "ü" + random.nextInt(3);
            case TIME -> at;
            case FLOAT8 -> 180 * random.nextDouble();
            case FLOAT4 -> random.nextFloat();
            case INTEGER -> random.nextInt(101);
            case TRUTH -> random.nextBoolean();
        };
    }

    List<List<@Nullable Object>> rows() {
        return rows;
    }

    /** As a process that dies would: after so many rows of a pass there are no more. */
    SimulatedRowSource failingAfter(int row) {
        failAfter = row;
        return this;
    }

    /** When it is asked a second time that row is another one. */
    SimulatedRowSource changing(int row) {
        wrongFrom = row;
        return this;
    }

    @Override
    public void of(LocalDate day, RowConsumer taker) throws IOException {
        passes++;
        if (!day.equals(DAY)) {
            return;
        }
        for (int i = 0; i < rows.size(); i++) {
            if (i == failAfter) {
                throw new IOException("the power is off");
            }
            boolean wrong = i == wrongFrom && passes == 2;
            taker.row(wrong ? rows.get(i + 1) : rows.get(i));
        }
    }
}

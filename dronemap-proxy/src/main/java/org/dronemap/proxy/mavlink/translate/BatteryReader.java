package org.dronemap.proxy.mavlink.translate;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Function;
import org.dronemap.core.drone.Battery;
import org.dronemap.mavlink.message.BatteryStatus;
import org.dronemap.mavlink.message.SysStatus;
import org.jspecify.annotations.Nullable;

/**
 * Reads the batteries of one vehicle out of SYS_STATUS, which has the main one's, and BATTERY_STATUS, which has each
 * one's: what the first leaves open is taken from the second as long as that is told. Owned by the drone's lane.
 */
final class BatteryReader {
    private static final int UNKNOWN_U16 = 65_535;
    private static final int UNKNOWN_CURRENT = -1;
    private static final int MOST_BATTERIES = 16;
    /** What SYS_STATUS can carry; some firmware begins at 0 again. */
    private static final double MOST_VOLTS_OF_SYS_STATUS = 65.5;
    /** MAV_BATTERY_FUNCTION: unknown, all, propulsion; what follows does not keep the vehicle in the air. */
    private static final int LAST_THAT_FLIES = 2;

    /** Two messages are told at different times. */
    private static final int SAME_PERCENT = 5;

    private static final double SAME_VOLTAGE = 0.2;

    private final Map<Integer, Source> batteries = new TreeMap<>();
    private final Source system = new Source();
    private boolean told;

    /** The values of one battery in one message, each null when unknown. */
    private record Reading(
            @Nullable Integer percent,
            @Nullable Double volts,
            @Nullable Double amps,
            boolean flies) {}

    /** One message of a vehicle, and how long what it said counts. */
    private static final class Source {
        private static final long SHORTEST_NANOS = 10_000_000_000L;
        private static final int INTERVALS = 3;

        private @Nullable Reading last;
        private long lastNanos;
        private long intervalNanos;

        void received(Reading reading, long nowNanos) {
            intervalNanos = last == null ? 0 : nowNanos - lastNanos;
            last = reading;
            lastNanos = nowNanos;
        }

        /** Null when it was told too long ago to be true now. */
        @Nullable
        Reading now(long nowNanos) {
            return nowNanos - lastNanos <= Math.max(SHORTEST_NANOS, INTERVALS * intervalNanos) ? last : null;
        }
    }

    /** Empty as long as nothing was ever known. */
    Optional<Battery> received(SysStatus message, long nowNanos) {
        int millivolts = message.voltageBattery();
        system.received(
                new Reading(
                        percent(message.batteryRemaining()),
                        millivolts == UNKNOWN_U16 || millivolts == 0 ? null : Double.valueOf(millivolts / 1000.0),
                        amps(message.currentBattery()),
                        true),
                nowNanos);
        return battery(nowNanos);
    }

    /** Empty as long as nothing was ever known. */
    Optional<Battery> received(BatteryStatus message, long nowNanos) {
        Source source = batteries.get(message.id());
        if (source == null) {
            if (batteries.size() == MOST_BATTERIES) {
                return Optional.empty();
            }
            source = new Source();
            batteries.put(message.id(), source);
        }
        int millivolts = sum(message.voltages()) + sum(message.voltagesExt());
        source.received(
                new Reading(
                        percent(message.batteryRemaining()),
                        millivolts == 0 ? null : Double.valueOf(millivolts / 1000.0),
                        amps(message.currentBattery()),
                        message.batteryFunction() <= LAST_THAT_FLIES),
                nowNanos);
        return battery(nowNanos);
    }

    /** The charge alone is known, as over a satellite. */
    Optional<Battery> received(int remaining, long nowNanos) {
        system.received(new Reading(percent(remaining), null, null, true), nowNanos);
        return battery(nowNanos);
    }

    private static int sum(int[] cells) {
        int millivolts = 0;
        for (int cell : cells) {
            millivolts += cell == UNKNOWN_U16 ? 0 : cell;
        }
        return millivolts;
    }

    private static @Nullable Integer percent(int value) {
        return value >= 0 && value <= 100 ? (Integer) value : null;
    }

    private static @Nullable Double amps(int centiamps) {
        boolean unknown = centiamps == UNKNOWN_CURRENT || centiamps == Short.MAX_VALUE || centiamps == Short.MIN_VALUE;
        return unknown ? null : Double.valueOf(centiamps / 100.0);
    }

    private Optional<Battery> battery(long nowNanos) {
        Integer main = main(nowNanos);
        Reading sys = system.now(nowNanos);
        Reading status = main == null ? null : reading(main, nowNanos);
        Double volts = first(sys, status, Reading::volts);
        Double whole = status == null ? null : status.volts();
        if (whole != null && whole > MOST_VOLTS_OF_SYS_STATUS) {
            volts = whole;
        }
        Battery now = new Battery(
                first(sys, status, Reading::percent),
                volts,
                first(sys, status, Reading::amps),
                further(main, nowNanos));
        told |= now.percent() != null
                || now.volts() != null
                || now.amps() != null
                || !now.further().isEmpty();
        return told ? Optional.of(now) : Optional.empty();
    }

    private static <T> @Nullable T first(
            @Nullable Reading sys, @Nullable Reading status, Function<Reading, @Nullable T> part) {
        T value = sys == null ? null : part.apply(sys);
        return value != null || status == null ? value : part.apply(status);
    }

    private @Nullable Reading reading(int number, long nowNanos) {
        Source source = batteries.get(number);
        return source == null ? null : source.now(nowNanos);
    }

    /** The first that keeps it in the air and may be the one of SYS_STATUS; null when none is told. */
    private @Nullable Integer main(long nowNanos) {
        Reading sys = system.now(nowNanos);
        Integer first = null;
        for (int number : batteries.keySet()) {
            Reading reading = reading(number, nowNanos);
            if (reading != null && reading.flies() && !isAnother(number, reading, sys)) {
                return number;
            }
            first = first == null && reading != null ? (Integer) number : first;
        }
        return sys == null ? first : null;
    }

    /** One beyond the first that tells clearly other values than SYS_STATUS is not the battery of that. */
    private static boolean isAnother(int number, Reading reading, @Nullable Reading sys) {
        if (number == 0 || sys == null) {
            return false;
        }
        Integer percent = reading.percent();
        Integer whole = sys.percent();
        if (percent != null && whole != null) {
            return Math.abs(percent - whole) > SAME_PERCENT;
        }
        Double volts = reading.volts();
        Double all = sys.volts();
        return volts != null && all != null && Math.abs(volts - all) > SAME_VOLTAGE * all;
    }

    private List<Battery.Further> further(@Nullable Integer main, long nowNanos) {
        List<Battery.Further> others = new ArrayList<>();
        for (int number : batteries.keySet()) {
            Reading reading = reading(number, nowNanos);
            if (reading != null && (main == null || number != main)) {
                others.add(new Battery.Further(number, reading.percent(), reading.volts(), reading.amps()));
            }
        }
        return others;
    }
}

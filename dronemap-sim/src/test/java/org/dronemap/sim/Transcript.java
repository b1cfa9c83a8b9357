package org.dronemap.sim;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.NoSuchElementException;
import java.util.function.Predicate;
import java.util.stream.DoubleStream;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.BatteryStatus;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.EkfStatusReport;
import org.dronemap.mavlink.message.ExtendedSysState;
import org.dronemap.mavlink.message.FenceStatus;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.HomePosition;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCurrent;
import org.dronemap.mavlink.message.MissionItemReached;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.Statustext;
import org.dronemap.mavlink.message.SysStatus;
import org.dronemap.mavlink.message.VfrHud;

/** What was said to a vehicle and what it said, in the order of time, real or simulated in the same form. Seconds. */
record Transcript(List<RecordedLine> lines) {
    private static final long PREARM_CHECK = 0x1000_0000;

    static Transcript of(List<RecordedLine> said, List<VehicleTestBench.Heard> heard, long start) {
        List<RecordedLine> all =
                new ArrayList<>(said.stream().filter(RecordedLine::isSaid).toList());
        heard.forEach(h -> all.add(line(h.frame(), h.millis() - start)));
        all.sort(Comparator.comparingLong(RecordedLine::millis));
        return new Transcript(all);
    }

    private static RecordedLine line(Frame f, long millis) {
        Map<String, String> fields = new HashMap<>(fields(f));
        fields.put("t_ms", "" + millis);
        fields.put("dir", "from");
        return new RecordedLine(fields);
    }

    private static Map<String, String> fields(Frame f) {
        return switch (f.messageId()) {
            case Heartbeat.ID -> {
                Heartbeat beat = Heartbeat.decode(f);
                boolean armed = (beat.baseMode() & 128) != 0;
                yield Map.of("msg", "HEARTBEAT", "custom_mode", "" + beat.customMode(), "armed", "" + armed);
            }
            case GlobalPositionInt.ID -> {
                GlobalPositionInt p = GlobalPositionInt.decode(f);
                yield numbers("GLOBAL_POSITION_INT", "lat", p.lat(), "relative_alt", p.relativeAlt(), "vz", p.vz());
            }
            case VfrHud.ID -> {
                VfrHud h = VfrHud.decode(f);
                yield numbers("VFR_HUD", "groundspeed", h.groundspeed(), "climb", h.climb(), "heading", h.heading());
            }
            case ExtendedSysState.ID ->
                numbers(
                        "EXTENDED_SYS_STATE",
                        "landed_state",
                        ExtendedSysState.decode(f).landedState());
            case MissionCurrent.ID -> {
                MissionCurrent current = MissionCurrent.decode(f);
                yield numbers(
                        "MISSION_CURRENT",
                        "seq",
                        current.seq(),
                        "total",
                        current.total(),
                        "mission_state",
                        current.missionState());
            }
            case HomePosition.ID -> Map.of("msg", "HOME_POSITION");
            case SysStatus.ID, EkfStatusReport.ID, FenceStatus.ID, BatteryStatus.ID -> stateFields(f);
            default -> answerFields(f);
        };
    }

    private static Map<String, String> stateFields(Frame f) {
        return switch (f.messageId()) {
            case SysStatus.ID ->
                numbers(
                        "SYS_STATUS",
                        "current_battery",
                        SysStatus.decode(f).currentBattery(),
                        "onboard_control_sensors_health",
                        SysStatus.decode(f).onboardControlSensorsHealth());
            case EkfStatusReport.ID ->
                numbers("EKF_STATUS_REPORT", "flags", EkfStatusReport.decode(f).flags());
            case FenceStatus.ID -> {
                FenceStatus fence = FenceStatus.decode(f);
                yield numbers(
                        "FENCE_STATUS",
                        "breach_status",
                        fence.breachStatus(),
                        "breach_count",
                        fence.breachCount(),
                        "breach_type",
                        fence.breachType());
            }
            case BatteryStatus.ID ->
                numbers("BATTERY_STATUS", "id", BatteryStatus.decode(f).id());
            default -> throw new IllegalArgumentException("no state is read from message " + f.messageId());
        };
    }

    private static Map<String, String> answerFields(Frame f) {
        return switch (f.messageId()) {
            case CommandAck.ID -> {
                CommandAck ack = CommandAck.decode(f);
                yield numbers("COMMAND_ACK", "command", ack.command(), "result", ack.result());
            }
            case Statustext.ID ->
                Map.of("msg", "STATUSTEXT", "text", Statustext.decode(f).text());
            case MissionAck.ID ->
                numbers("MISSION_ACK", "type", MissionAck.decode(f).type());
            case MissionRequest.ID ->
                numbers("MISSION_REQUEST", "seq", MissionRequest.decode(f).seq());
            case MissionItemReached.ID ->
                numbers(
                        "MISSION_ITEM_REACHED",
                        "seq",
                        MissionItemReached.decode(f).seq());
            default -> Map.of("msg", "" + f.messageId());
        };
    }

    /** Names and values in turn. */
    private static Map<String, String> numbers(String message, Object... namesAndValues) {
        Map<String, String> fields = new HashMap<>(Map.of("msg", message));
        for (int i = 0; i < namesAndValues.length; i += 2) {
            fields.put("" + namesAndValues[i], "" + namesAndValues[i + 1]);
        }
        return fields;
    }

    static Predicate<RecordedLine> sent(int command) {
        return line -> line.isSaid() && line.is("COMMAND_LONG") && line.integer("command") == command;
    }

    /** EXTENDED_SYS_STATE: 1 on the ground, 2 in the air, 3 taking off, 4 landing. */
    static Predicate<RecordedLine> landed(int state) {
        return with("EXTENDED_SYS_STATE", "landed_state", state);
    }

    static Predicate<RecordedLine> with(String message, String field, long value) {
        return line -> line.is(message) && line.integer(field) == value;
    }

    static Predicate<RecordedLine> said(String text) {
        return line -> line.is("STATUSTEXT") && line.text("text").startsWith(text);
    }

    static double seconds(RecordedLine line) {
        return line.millis() / 1000.0;
    }

    /** Each value of the field that differs from the one before. */
    List<VehicleAnswer> changes(String message, String field) {
        List<VehicleAnswer> changes = new ArrayList<>();
        String last = "";
        for (RecordedLine line : lines) {
            if (!line.isSaid() && line.is(message) && !line.text(field).equals(last)) {
                last = line.text(field);
                changes.add(new VehicleAnswer(field, last, line.millis()));
            }
        }
        return changes;
    }

    /** Whether the pre-arm checks are passed, wherever that changes. */
    List<VehicleAnswer> readiness() {
        List<VehicleAnswer> changes = new ArrayList<>();
        String last = "";
        for (RecordedLine line : lines) {
            if (line.is("SYS_STATUS")) {
                String now = (line.integer("onboard_control_sensors_health") & PREARM_CHECK) == 0 ? "no" : "ready";
                if (!now.equals(last)) {
                    changes.add(new VehicleAnswer("prearm", now, line.millis()));
                    last = now;
                }
            }
        }
        return changes;
    }

    /** When the first such line after {@code after} was seen. */
    double secondsOf(double after, Predicate<RecordedLine> wanted) {
        return lines.stream()
                .filter(line -> seconds(line) > after && wanted.test(line))
                .mapToDouble(Transcript::seconds)
                .findFirst()
                .orElseThrow(() -> new NoSuchElementException("no such line after " + after + " s"));
    }

    double secondsOf(Predicate<RecordedLine> wanted) {
        return secondsOf(Double.NEGATIVE_INFINITY, wanted);
    }

    double lastSecondsBefore(double end, Predicate<RecordedLine> wanted) {
        return lines.stream()
                .filter(line -> seconds(line) < end && wanted.test(line))
                .mapToDouble(Transcript::seconds)
                .max()
                .orElseThrow();
    }

    double between(Predicate<RecordedLine> first, Predicate<RecordedLine> then) {
        double started = secondsOf(first);
        return secondsOf(started, then) - started;
    }

    /** One field of all messages of a kind, within a time. */
    double[] values(String message, String field, double from, double until) {
        return lines.stream()
                .filter(line -> line.is(message) && seconds(line) >= from && seconds(line) <= until)
                .mapToDouble(line -> line.number(field))
                .toArray();
    }

    double greatest(String message, String field, double from, double until) {
        return DoubleStream.of(values(message, field, from, until)).max().orElseThrow();
    }

    double greatest(String message, String field) {
        return greatest(message, field, Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY);
    }

    static double median(double[] values) {
        double[] sorted = values.clone();
        Arrays.sort(sorted);
        return (sorted[(sorted.length - 1) / 2] + sorted[sorted.length / 2]) / 2;
    }
}

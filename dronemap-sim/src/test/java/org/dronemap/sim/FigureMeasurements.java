package org.dronemap.sim;

import static org.dronemap.sim.Transcript.landed;
import static org.dronemap.sim.Transcript.median;
import static org.dronemap.sim.Transcript.said;
import static org.dronemap.sim.Transcript.seconds;
import static org.dronemap.sim.Transcript.sent;
import static org.dronemap.sim.Transcript.with;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.ToDoubleFunction;
import java.util.stream.LongStream;

/** How each figure of {@code measured.json} is taken from a transcript; the meanings and units are written there. */
final class FigureMeasurements {
    private static final double METERS_PER_DEGREE = 111_319.5;
    private static final double ALWAYS = Double.POSITIVE_INFINITY;

    private final Map<String, ToDoubleFunction<Transcript>> byKey = new HashMap<>();

    FigureMeasurements() {
        addGround();
        addTakeOffAndLanding();
        addLegs();
        addLeading();
        addMissions();
        addReturns();
        addFaults();
    }

    ToDoubleFunction<Transcript> of(String key) {
        ToDoubleFunction<Transcript> measure = byKey.get(key);
        if (measure == null) {
            throw new IllegalArgumentException("nobody knows how to take " + key);
        }
        return measure;
    }

    private void addGround() {
        byKey.put("acknowledgementSeconds", FigureMeasurements::acknowledgementSeconds);
        byKey.put("homeSetSeconds", t -> t.secondsOf(line -> line.is("HOME_POSITION")));
        byKey.put(
                "armingGrantedSeconds",
                t -> t.secondsOf(
                        line -> with("COMMAND_ACK", "command", 400).test(line) && line.integer("result") == 0));
        byKey.put(
                "groundDisarmSeconds",
                t -> t.secondsOf(5, said("Disarming motors")) - t.secondsOf(5, said("Arming motors")));
        byKey.put("turnedDegrees", FigureMeasurements::turnedDegrees);
    }

    private void addTakeOffAndLanding() {
        byKey.put("spoolUpSeconds", t -> t.between(sent(22), landed(3)));
        byKey.put("takeoffSeconds", t -> t.between(sent(22), landed(2)));
        byKey.put("climbRate", t -> t.greatest("VFR_HUD", "climb"));
        byKey.put("takeoffOvershoot", t -> highest(t) - 20);
        byKey.put("landingSeconds", t -> t.between(sent(21), landed(1)));
        byKey.put("descentRateHigh", t -> descentRate(t, 12, 18));
        byKey.put("descentRateLow", t -> descentRate(t, 1, 8));
        byKey.put(
                "onGroundToDisarmSeconds",
                t -> t.between(landed(4), said("Disarming motors")) - t.between(landed(4), landed(1)));
        byKey.put("hoverAmperes", t -> median(t.values("SYS_STATUS", "current_battery", 8, 45)) / 100);
    }

    private void addLegs() {
        byKey.put("cruiseSpeed", t -> t.greatest("VFR_HUD", "groundspeed"));
        byKey.put("legSeconds", FigureMeasurements::legSeconds);
        byKey.put(
                "secondsTo9MetersPerSecond",
                t -> t.secondsOf(line -> line.is("VFR_HUD") && line.number("groundspeed") >= 9));
        byKey.put("stoppingDistance", FigureMeasurements::stoppingDistance);
        byKey.put("loiterSinkRate", FigureMeasurements::loiterSinkRate);
        byKey.put("changedSpeed", FigureMeasurements::secondLegSpeed);
        byKey.put("changedSpeedLost", t -> t.greatest("VFR_HUD", "groundspeed"));
    }

    private void addLeading() {
        byKey.put("ledSpeed", t -> median(whileLed(t, "VFR_HUD", "groundspeed")));
        byKey.put("ledBehind", FigureMeasurements::ledBehind);
        byKey.put("ledHeading", t -> median(whileLed(t, "VFR_HUD", "heading")));
        byKey.put("leftAloneMeters", FigureMeasurements::leftAloneMeters);
        byKey.put(
                "leftAloneOvershoot",
                t -> north(last(latitudes(t)), LongStream.of(latitudes(t)).max().orElseThrow()));
        byKey.put(
                "leftAloneSeconds",
                t -> t.secondsOf(ledUntil(t), line -> line.is("VFR_HUD") && line.number("groundspeed") < 1)
                        - ledUntil(t));
    }

    private void addMissions() {
        byKey.put(
                "uploadSeconds",
                t -> t.between(line -> line.isSaid() && line.is("MISSION_COUNT"), line -> line.is("MISSION_ACK")));
        byKey.put("itemRequestSeconds", FigureMeasurements::requestInterval);
        byKey.put("uploadTimeoutSeconds", FigureMeasurements::uploadTimeout);
        byKey.put(
                "missionSeconds",
                t -> t.between(
                        sent(300),
                        line -> line.is("HEARTBEAT") && line.text("armed").equals("false")));
        byKey.put("missionTakeoffSeconds", t -> t.between(sent(300), with("MISSION_ITEM_REACHED", "seq", 1)));
        byKey.put("missionRtlLoiterSeconds", t -> t.between(with("MISSION_ITEM_REACHED", "seq", 4), landed(4)));
    }

    private void addReturns() {
        byKey.put("rtlHeightFromBelow", FigureMeasurements::highest);
        byKey.put("rtlHeightFromAbove", FigureMeasurements::highest);
        byKey.put("rtlToLandingSeconds", t -> t.between(sent(20), landed(4)));
        byKey.put("rtlOverHomeSeconds", t -> t.between(sent(176), landed(4)));
    }

    private void addFaults() {
        byKey.put("batteryLowSeconds", t -> sinceParameter(t, "Battery Failsafe"));
        byKey.put("groundStationLostSeconds", FigureMeasurements::silenceBeforeFailsafe);
        byKey.put("gpsLostSeconds", t -> sinceParameter(t, "EKF Failsafe: changed to LAND Mode"));
        byKey.put(
                "gpsBackSeconds",
                t -> t.between(
                        line -> line.is("PARAM_SET") && line.number("param_value") == 0, said("EKF Failsafe Cleared")));
        byKey.put("fallSpeed", t -> t.greatest("GLOBAL_POSITION_INT", "vz") / 100);
        byKey.put("thrustLossSeconds", t -> sinceParameter(t, "Potential Thrust Loss"));
    }

    private static double acknowledgementSeconds(Transcript t) {
        Map<String, Double> waiting = new HashMap<>();
        List<Double> delays = new ArrayList<>();
        for (RecordedLine line : t.lines()) {
            String command = line.text("command");
            if (line.is("COMMAND_LONG") || line.is("COMMAND_INT")) {
                waiting.put(command, seconds(line));
            } else if (line.is("COMMAND_ACK") && waiting.containsKey(command)) {
                delays.add(seconds(line) - waiting.remove(command));
            }
        }
        return median(delays.stream().mapToDouble(Double::doubleValue).toArray());
    }

    private static double turnedDegrees(Transcript t) {
        double first = t.secondsOf(sent(115));
        double[] headings = t.values("VFR_HUD", "heading", first - 1.5, first + 6);
        return (headings[headings.length - 1] - headings[0] + 360) % 360;
    }

    private static double highest(Transcript t) {
        return t.greatest("GLOBAL_POSITION_INT", "relative_alt") / 1000;
    }

    /** The median rate of sinking between two heights after the landing began. */
    private static double descentRate(Transcript t, double low, double high) {
        double started = t.secondsOf(landed(4));
        return median(t.lines().stream()
                .filter(line -> line.is("GLOBAL_POSITION_INT") && seconds(line) > started)
                .filter(line -> line.number("relative_alt") > low * 1000 && line.number("relative_alt") < high * 1000)
                .mapToDouble(line -> line.number("vz") / 100)
                .toArray());
    }

    private static double legSeconds(Transcript t) {
        long target = t.lines().stream()
                .filter(line -> line.is("SET_POSITION_TARGET_GLOBAL_INT"))
                .findFirst()
                .orElseThrow()
                .integer("lat_int");
        return t.secondsOf(line ->
                line.is("GLOBAL_POSITION_INT") && Math.abs(line.integer("lat") - target) < 1e7 / METERS_PER_DEGREE);
    }

    private static double ledUntil(Transcript t) {
        return t.lastSecondsBefore(ALWAYS, line -> line.is("SET_POSITION_TARGET_GLOBAL_INT"));
    }

    /** From when it has caught up until the last place was said. */
    private static double[] whileLed(Transcript t, String message, String field) {
        return t.values(message, field, ledUntil(t) - 7, ledUntil(t));
    }

    private static double ledBehind(Transcript t) {
        double end = ledUntil(t);
        long place = 0;
        List<Double> behind = new ArrayList<>();
        for (RecordedLine line : t.lines()) {
            if (line.is("SET_POSITION_TARGET_GLOBAL_INT")) {
                place = line.integer("lat_int");
            } else if (line.is("GLOBAL_POSITION_INT") && seconds(line) >= end - 7 && seconds(line) <= end) {
                behind.add((place - line.integer("lat")) * 1e-7 * METERS_PER_DEGREE);
            }
        }
        return median(behind.stream().mapToDouble(Double::doubleValue).toArray());
    }

    /** Metres to the north of the last place that was said, in the end. */
    private static double leftAloneMeters(Transcript t) {
        return north(last(integers(t, "SET_POSITION_TARGET_GLOBAL_INT", "lat_int")), last(latitudes(t)));
    }

    private static long[] latitudes(Transcript t) {
        return integers(t, "GLOBAL_POSITION_INT", "lat");
    }

    private static long[] integers(Transcript t, String message, String field) {
        return t.lines().stream()
                .filter(line -> line.is(message))
                .mapToLong(line -> line.integer(field))
                .toArray();
    }

    private static double north(long from, long to) {
        return (to - from) * 1e-7 * METERS_PER_DEGREE;
    }

    /** Metres flown on to the north within six seconds of the order to pause. */
    private static double stoppingDistance(Transcript t) {
        double asked = t.secondsOf(sent(193));
        double[] latitudes = t.lines().stream()
                .filter(line -> line.is("GLOBAL_POSITION_INT"))
                .filter(line -> seconds(line) >= asked && seconds(line) <= asked + 6)
                .mapToDouble(line -> line.integer("lat"))
                .toArray();
        return (latitudes[latitudes.length - 1] - latitudes[0]) * 1e-7 * METERS_PER_DEGREE;
    }

    private static double loiterSinkRate(Transcript t) {
        double started = t.secondsOf(with("HEARTBEAT", "custom_mode", 5));
        return t.greatest("GLOBAL_POSITION_INT", "vz", started, started + 6) / 100;
    }

    private static long last(long[] values) {
        return values[values.length - 1];
    }

    private static double secondLegSpeed(Transcript t) {
        double second = t.lines().stream()
                .filter(line -> line.is("SET_POSITION_TARGET_GLOBAL_INT"))
                .skip(1)
                .mapToDouble(Transcript::seconds)
                .findFirst()
                .orElseThrow();
        return t.greatest("VFR_HUD", "groundspeed", second + 2, ALWAYS);
    }

    /** The median of the last five pauses between requests for the same item. */
    private static double requestInterval(Transcript t) {
        double[] asked = t.lines().stream()
                .filter(with("MISSION_REQUEST", "seq", 2))
                .mapToDouble(Transcript::seconds)
                .toArray();
        double[] pauses = new double[5];
        for (int i = 0; i < pauses.length; i++) {
            int later = asked.length - pauses.length + i;
            pauses[i] = asked[later] - asked[later - 1];
        }
        return median(pauses);
    }

    private static double uploadTimeout(Transcript t) {
        double gaveUp = t.secondsOf(with("MISSION_ACK", "type", 15));
        return gaveUp - t.lastSecondsBefore(gaveUp, line -> line.isSaid() && line.is("MISSION_ITEM_INT"));
    }

    private static double silenceBeforeFailsafe(Transcript t) {
        double acted = t.secondsOf(said("GCS Failsafe"));
        return acted - t.lastSecondsBefore(acted, line -> line.isSaid() && line.is("HEARTBEAT"));
    }

    private static double sinceParameter(Transcript t, String text) {
        return t.between(line -> line.isSaid() && line.is("PARAM_SET"), said(text));
    }
}

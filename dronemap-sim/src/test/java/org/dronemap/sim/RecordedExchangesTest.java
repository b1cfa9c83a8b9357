package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;

/**
 * Says to the simulated vehicle, at the same times, what was said to a real one, and compares what comes back: modes,
 * result codes, mission answers and sentences in the same order, each within two seconds plus a tenth of the time gone by.
 */
class RecordedExchangesTest {
    private static final long SEEN_MILLIS = 250;

    @ParameterizedTest
    @EnumSource
    void answersAsTheRealOneDid(RecordedExchange exchange) {
        RecordedScenario scene = new RecordedScenario(exchange);
        String firstMode = scene.mode();
        scene.play();
        for (String kind : List.of("ack", "mode", "text", "mission")) {
            compare(kind, ofKind(scene.real(), kind, firstMode), ofKind(scene.simulated(), kind, firstMode));
        }
    }

    /** MISSION_FROM_THE_AIR was recorded with the last half metre of the climb still to go. */
    @ParameterizedTest
    @EnumSource(mode = EnumSource.Mode.EXCLUDE, names = "MISSION_FROM_THE_AIR")
    void tellsTheSameStates(RecordedExchange exchange) {
        RecordedScenario scene = new RecordedScenario(exchange);
        scene.play();
        compare(
                "landed",
                lasting(scene.recorded().changes("EXTENDED_SYS_STATE", "landed_state")),
                lasting(scene.played().changes("EXTENDED_SYS_STATE", "landed_state")));
        compare(
                "armed",
                scene.recorded().changes("HEARTBEAT", "armed"),
                scene.played().changes("HEARTBEAT", "armed"));
    }

    /** Where the items change too quickly to be seen in a message sent five times a second, chance decides. */
    @ParameterizedTest
    @EnumSource(
            mode = EnumSource.Mode.EXCLUDE,
            names = {
                "MISSION_FROM_THE_AIR",
                "MISSION_UPLOAD_REFUSED",
                "PLANE_MISSION_UPLOAD",
                "ROVER_GROUND_STATION_LOST_IN_AUTO",
                "ROVER_MISSION_UPLOAD"
            })
    void tellsTheSameProgress(RecordedExchange exchange) {
        RecordedScenario scene = new RecordedScenario(exchange);
        scene.play();
        for (String field : List.of("seq", "mission_state", "total")) {
            compare(
                    field,
                    lasting(scene.recorded().changes("MISSION_CURRENT", field)),
                    lasting(scene.played().changes("MISSION_CURRENT", field)));
        }
    }

    /** What is otherwise again sooner than such a message comes is seen by chance. */
    private static List<VehicleAnswer> lasting(List<VehicleAnswer> changes) {
        List<VehicleAnswer> chosen = new ArrayList<>();
        for (int i = 0; i < changes.size(); i++) {
            VehicleAnswer change = changes.get(i);
            boolean lasts = i + 1 == changes.size() || changes.get(i + 1).millis() - change.millis() > SEEN_MILLIS;
            boolean other =
                    chosen.isEmpty() || !chosen.get(chosen.size() - 1).text().equals(change.text());
            if (lasts && other) {
                chosen.add(change);
            }
        }
        return chosen;
    }

    /** Of the exchanges that have them recorded: the estimator's flags, whether it would arm, and its fence. */
    @ParameterizedTest
    @EnumSource(
            names = {
                "READINESS_BY_MODE",
                "GPS_BACK_ON_GROUND",
                "GPS_GAP_IN_FLIGHT",
                "MODES_WITHOUT_GPS_IN_FLIGHT",
                "FENCE_SWITCHED",
                "FENCE_ARMING_OUTSIDE",
                "FENCE_TARGETS_OUTSIDE",
                "FENCE_BREACHED_IN_AUTO",
                "FENCE_BREACHED_IN_HEIGHT",
                "FENCE_BREACH_ONLY_TOLD",
                "SECOND_BATTERY_LOW"
            })
    void tellsTheSameEstimateReadinessAndFence(RecordedExchange exchange) {
        RecordedScenario scene = new RecordedScenario(exchange);
        scene.play();
        Transcript real = scene.recorded();
        Transcript simulated = scene.played();
        compare(
                "estimate",
                real.changes("EKF_STATUS_REPORT", "flags"),
                simulated.changes("EKF_STATUS_REPORT", "flags"));
        compare("prearm", real.readiness(), simulated.readiness());
        for (String field : List.of("breach_status", "breach_type", "breach_count")) {
            compare(field, real.changes("FENCE_STATUS", field), simulated.changes("FENCE_STATUS", field));
        }
    }

    @Test
    void noRecordingIsLeftOut() throws IOException {
        try (Stream<Path> files = Files.list(Path.of("exchanges", "recorded"))) {
            assertThat(files.map(file -> file.getFileName().toString()).filter(name -> name.endsWith(".jsonl")))
                    .containsExactlyInAnyOrderElementsOf(Arrays.stream(RecordedExchange.values())
                            .map(exchange -> exchange.fileName() + ".jsonl")
                            .toList());
        }
    }

    private static List<VehicleAnswer> ofKind(List<VehicleAnswer> all, String kind, String firstMode) {
        List<VehicleAnswer> chosen =
                all.stream().filter(answer -> answer.kind().equals(kind)).toList();
        return switch (kind) {
            case "mode" -> changes(chosen, firstMode);
            case "mission" -> withoutRepeatedRequests(chosen);
            default -> chosen;
        };
    }

    /** Of the heartbeats only those count that tell of another mode. */
    private static List<VehicleAnswer> changes(List<VehicleAnswer> heartbeats, String firstMode) {
        List<VehicleAnswer> changes = new ArrayList<>();
        String mode = firstMode;
        for (VehicleAnswer heartbeat : heartbeats) {
            if (!heartbeat.text().equals(mode)) {
                changes.add(heartbeat);
                mode = heartbeat.text();
            }
        }
        return changes;
    }

    /**
     * An item that is missing is asked for again each second; whether just before or just after a message of the same instant
     * is chance. How often is among the measured figures.
     */
    private static List<VehicleAnswer> withoutRepeatedRequests(List<VehicleAnswer> answers) {
        List<VehicleAnswer> chosen = new ArrayList<>();
        VehicleAnswer last = new VehicleAnswer("mission", "", 0);
        for (VehicleAnswer answer : answers) {
            boolean request = answer.text().startsWith("ask ");
            long since = answer.millis() - last.millis();
            if (!request || !answer.text().equals(last.text()) || since < 900 || since > 1_200) {
                chosen.add(answer);
            }
            last = request ? answer : last;
        }
        return chosen;
    }

    private static void compare(String kind, List<VehicleAnswer> real, List<VehicleAnswer> simulated) {
        assertThat(simulated.stream().map(VehicleAnswer::line))
                .as(kind)
                .containsExactlyElementsOf(
                        real.stream().map(VehicleAnswer::line).toList());
        for (int i = 0; i < real.size(); i++) {
            long seen = real.get(i).millis();
            assertThat(simulated.get(i).millis())
                    .as("time of %s", real.get(i).line())
                    .isBetween(seen - 2_000 - seen / 10, seen + 2_000 + seen / 10);
        }
    }
}

package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Says to the simulated vehicle, at the same times, what was said to a real ArduCopter, and compares what comes back: modes,
 * result codes, mission answers and sentences in the same order, each within two seconds plus a tenth of the time gone by.
 */
class RecordedExchangesTest {
    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "arming_refused, 0, power-up",
        "modes_refused, 0, power-up",
        "modes_refused_armed, 0, without GPS and checks",
        "gps_missing_on_ground, 0, without GPS",
        "messages_asked_for, 0, ''",
        "commands_odd, 0, ''",
        "guided_takeoff, 0, ''",
        "mission_upload_refused, 0, ''",
        "mission_from_the_air, 20, five items",
        "mission_cleared_in_flight, 20, in AUTO",
        "ground_station_lost_in_auto, 20, 'in AUTO, ground station'",
        "hold_in_flight, 30, ''",
        "speed_and_home, 20, ''",
        "go_to_by_setpoint, 20, ''",
        "rtl_from_8_m, 8, ''",
        "arm_and_disarm, 0, ''",
        "arming_by_mode, 0, ''",
        "takeoff_refused, 0, ''",
        "commands_twice, 0, guided",
        "mission_upload, 0, ''",
        "mission_flight, 0, six items",
        "disarm_in_flight, 20, ''",
        "modes_refused_in_flight, 20, ''",
        "go_to_by_reposition, 20, ''",
        "rtl_from_20_m, 20, ''",
        "rtl_close_to_home, 8, ''",
        "battery_low, 20, battery",
        "battery_critical, 20, battery",
        "battery_low_by_default, 20, ''",
        "gps_lost, 20, ''",
        "ground_station_lost, 20, ground station",
        "ground_station_lost_by_default, 20, ''",
        "motor_failure, 30, ''"
    })
    void answersAsTheRealOneDid(String exchange, double height, String preparation) {
        Scene scene = new Scene(exchange, height, preparation);
        String firstMode = scene.mode();
        scene.play();
        for (String kind : List.of("ack", "mode", "text", "mission")) {
            compare(kind, ofKind(scene.real(), kind, firstMode), ofKind(scene.simulated(), kind, firstMode));
        }
    }

    private static List<Answer> ofKind(List<Answer> all, String kind, String firstMode) {
        List<Answer> chosen =
                all.stream().filter(answer -> answer.kind().equals(kind)).toList();
        return switch (kind) {
            case "mode" -> changes(chosen, firstMode);
            case "mission" -> withoutRepeatedRequests(chosen);
            default -> chosen;
        };
    }

    /** Of the heartbeats only those count that tell of another mode. */
    private static List<Answer> changes(List<Answer> heartbeats, String firstMode) {
        List<Answer> changes = new ArrayList<>();
        String mode = firstMode;
        for (Answer heartbeat : heartbeats) {
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
    private static List<Answer> withoutRepeatedRequests(List<Answer> answers) {
        List<Answer> chosen = new ArrayList<>();
        Answer last = new Answer("mission", "", 0);
        for (Answer answer : answers) {
            boolean request = answer.text().startsWith("ask ");
            long since = answer.millis() - last.millis();
            if (!request || !answer.text().equals(last.text()) || since < 900 || since > 1_200) {
                chosen.add(answer);
            }
            last = request ? answer : last;
        }
        return chosen;
    }

    private static void compare(String kind, List<Answer> real, List<Answer> simulated) {
        assertThat(simulated.stream().map(Answer::line))
                .as(kind)
                .containsExactlyElementsOf(real.stream().map(Answer::line).toList());
        for (int i = 0; i < real.size(); i++) {
            long seen = real.get(i).millis();
            assertThat(simulated.get(i).millis())
                    .as("time of %s", real.get(i).line())
                    .isBetween(seen - 2_000 - seen / 10, seen + 2_000 + seen / 10);
        }
    }
}

package org.dronemap.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionClearAll;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionItemReached;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.mavlink.message.MissionRequestList;
import org.dronemap.mavlink.message.SetMode;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.Statustext;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Says to the simulated vehicle, at the same times, what was said to a real ArduCopter, and compares what comes back: modes,
 * result codes, mission answers and sentences in the same order, each within two seconds plus a tenth of the time gone by.
 */
class RecordedExchangesTest {
    private static final Path RECORDED = Path.of("exchanges", "recorded");
    private static final String HOME = "-35.3632610,149.1652299,584.05";

    /** Kind of answer, its text, and when it came. */
    record Answer(String kind, String text, long millis) {
        String line() {
            return kind + " " + text;
        }
    }

    @ParameterizedTest(name = "{0}")
    @CsvSource({
        "arm_and_disarm, 0, ''",
        "arming_by_mode, 0, ''",
        "takeoff_refused, 0, ''",
        "commands_twice, 0, guided",
        "mission_upload, 0, ''",
        "mission_flight, 0, mission",
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
    void answersAsTheRealOneDid(String name, double height, String preparation) throws IOException {
        List<JsonLine> lines = JsonLine.read(RECORDED.resolve(name + ".jsonl"));
        Bench bench = prepare(lines, height, preparation);
        String firstMode = "" + bench.mode();
        List<Answer> simulated = replay(bench, lines);
        List<Answer> real = lines.stream()
                .filter(line -> line.text("dir").equals("from"))
                .map(RecordedExchangesTest::fromRecording)
                .flatMap(java.util.Optional::stream)
                .toList();
        for (String kind : List.of("ack", "mode", "text", "mission")) {
            compare(kind, ofKind(real, kind, firstMode), ofKind(simulated, kind, firstMode));
        }
    }

    /** Of the heartbeats only those count that tell of another mode. */
    private static List<Answer> ofKind(List<Answer> all, String kind, String firstMode) {
        List<Answer> chosen = new ArrayList<>();
        String mode = firstMode;
        for (Answer answer : all) {
            boolean news = !kind.equals("mode") || !answer.text().equals(mode);
            if (answer.kind().equals(kind) && news) {
                chosen.add(answer);
                mode = answer.text();
            }
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

    private static Bench prepare(List<JsonLine> lines, double height, String preparation) {
        String[] options = {"--home", HOME, "--stick", "low"};
        Bench bench = height > 0 ? Bench.flying(height, options) : Bench.ready(options);
        switch (preparation) {
            case "battery" -> {
                bench.parameter("BATT_LOW_VOLT", 11.5);
                bench.parameter("BATT_CRT_VOLT", 10.5);
                bench.parameter("BATT_FS_LOW_ACT", 2);
                bench.parameter("BATT_FS_CRT_ACT", 1);
            }
            case "guided" -> bench.command(176, 1, 4);
            case "ground station" -> bench.parameter("FS_GCS_ENABLE", 1);
            case "mission" -> {
                List<MissionItemInt> items = uploadedBefore();
                bench.upload(items.toArray(new MissionItemInt[0]));
            }
            default -> {}
        }
        long north = lines.stream()
                .filter(line -> line.text("msg").equals("GLOBAL_POSITION_INT"))
                .mapToLong(line -> line.integer("lat"))
                .findFirst()
                .orElse(0);
        if (height == 20 && Math.abs(north + 353_632_610) > 500) {
            bench.send(new SetPositionTargetGlobalInt(
                    0, 1, 1, 6, 3576, (int) north, 1_491_652_299, 20, 0, 0, 0, 0, 0, 0, 0, 0));
            bench.run(25);
        }
        bench.heard.clear();
        return bench;
    }

    /** The six items of the recorded upload, which the recorded flight then flew. */
    private static List<MissionItemInt> uploadedBefore() {
        try {
            return JsonLine.read(RECORDED.resolve("mission_upload.jsonl")).stream()
                    .filter(line -> line.text("msg").equals("MISSION_ITEM_INT")
                            && line.text("dir").equals("to"))
                    .limit(6)
                    .map(RecordedExchangesTest::item)
                    .toList();
        } catch (IOException e) {
            throw new java.io.UncheckedIOException(e);
        }
    }

    private static List<Answer> replay(Bench bench, List<JsonLine> lines) {
        long start = bench.now();
        boolean ownBeats = lines.stream()
                .noneMatch(l -> l.text("dir").equals("to") && l.text("msg").equals("HEARTBEAT"));
        bench.groundTalks(ownBeats);
        for (JsonLine line : lines) {
            bench.runTo(start + line.integer("t_ms"));
            if (line.text("dir").equals("to")) {
                say(bench, line);
            }
        }
        bench.run(1);
        return bench.heard.stream()
                .map(heard -> fromVehicle(heard, start))
                .flatMap(java.util.Optional::stream)
                .toList();
    }

    private static void say(Bench bench, JsonLine l) {
        switch (l.text("msg")) {
            case "HEARTBEAT" -> bench.send(new Heartbeat(6, 8, 0, 0, 4, 3));
            case "PARAM_SET" -> bench.parameter(l.text("param_id"), l.number("param_value"));
            case "COMMAND_LONG" ->
                bench.send(new CommandLong(
                        1,
                        1,
                        (int) l.integer("command"),
                        0,
                        l.number("param1"),
                        l.number("param2"),
                        l.number("param3"),
                        l.number("param4"),
                        l.number("param5"),
                        l.number("param6"),
                        l.number("param7")));
            case "COMMAND_INT" -> bench.send(commandInt(l));
            case "SET_POSITION_TARGET_GLOBAL_INT" -> bench.send(target(l));
            case "SET_MODE" -> bench.send(new SetMode(1, 1, l.integer("custom_mode")));
            case "MISSION_COUNT" -> bench.send(new MissionCount(1, 1, (int) l.integer("count"), 0));
            case "MISSION_ITEM_INT" -> bench.send(item(l));
            case "MISSION_REQUEST_LIST" -> bench.send(new MissionRequestList(1, 1, 0));
            case "MISSION_REQUEST_INT" -> bench.send(new MissionRequestInt(1, 1, (int) l.integer("seq"), 0));
            case "MISSION_CLEAR_ALL" -> bench.send(new MissionClearAll(1, 1, 0));
            case "MISSION_ACK" -> bench.send(new MissionAck(1, 1, 0, 0));
            default -> throw new IllegalArgumentException("a message that the test cannot say: " + l.text("msg"));
        }
    }

    private static CommandInt commandInt(JsonLine l) {
        return new CommandInt(
                1,
                1,
                (int) l.integer("frame"),
                (int) l.integer("command"),
                0,
                0,
                l.number("param1"),
                l.number("param2"),
                l.number("param3"),
                l.number("param4"),
                (int) l.integer("x"),
                (int) l.integer("y"),
                l.number("z"));
    }

    private static SetPositionTargetGlobalInt target(JsonLine l) {
        int north = (int) l.integer("lat_int");
        int east = (int) l.integer("lon_int");
        return new SetPositionTargetGlobalInt(
                0, 1, 1, 6, (int) l.integer("type_mask"), north, east, l.number("alt"), 0, 0, 0, 0, 0, 0, 0, 0);
    }

    private static MissionItemInt item(JsonLine l) {
        return new MissionItemInt(
                1,
                1,
                (int) l.integer("seq"),
                (int) l.integer("frame"),
                (int) l.integer("command"),
                0,
                1,
                l.number("param1"),
                l.number("param2"),
                l.number("param3"),
                l.number("param4"),
                (int) l.integer("x"),
                (int) l.integer("y"),
                l.number("z"),
                0);
    }

    private static java.util.Optional<Answer> fromRecording(JsonLine l) {
        long at = l.integer("t_ms");
        return switch (l.text("msg")) {
            case "COMMAND_ACK" -> ack(l.integer("command"), l.integer("result"), at);
            case "HEARTBEAT" -> java.util.Optional.of(new Answer("mode", "" + l.integer("custom_mode"), at));
            case "STATUSTEXT" -> text(l.text("text"), at);
            case "MISSION_ACK" -> java.util.Optional.of(new Answer("mission", "ack " + l.integer("type"), at));
            case "MISSION_COUNT" -> java.util.Optional.of(new Answer("mission", "count " + l.integer("count"), at));
            case "MISSION_REQUEST" -> java.util.Optional.of(new Answer("mission", "ask " + l.integer("seq"), at));
            case "MISSION_ITEM_REACHED" ->
                java.util.Optional.of(new Answer("mission", "reached " + l.integer("seq"), at));
            default -> java.util.Optional.empty();
        };
    }

    private static java.util.Optional<Answer> fromVehicle(Bench.Heard heard, long start) {
        var f = heard.frame();
        long at = heard.millis() - start;
        return switch (f.messageId()) {
            case CommandAck.ID ->
                ack(CommandAck.decode(f).command(), CommandAck.decode(f).result(), at);
            case Heartbeat.ID ->
                java.util.Optional.of(
                        new Answer("mode", "" + Heartbeat.decode(f).customMode(), at));
            case Statustext.ID -> text(Statustext.decode(f).text(), at);
            case MissionAck.ID ->
                java.util.Optional.of(
                        new Answer("mission", "ack " + MissionAck.decode(f).type(), at));
            case MissionCount.ID ->
                java.util.Optional.of(
                        new Answer("mission", "count " + MissionCount.decode(f).count(), at));
            case MissionRequest.ID ->
                java.util.Optional.of(
                        new Answer("mission", "ask " + MissionRequest.decode(f).seq(), at));
            case MissionItemReached.ID ->
                java.util.Optional.of(new Answer(
                        "mission", "reached " + MissionItemReached.decode(f).seq(), at));
            default -> java.util.Optional.empty();
        };
    }

    private static java.util.Optional<Answer> ack(long command, long result, long at) {
        return command == 511
                ? java.util.Optional.empty()
                : java.util.Optional.of(new Answer("ack", command + " " + result, at));
    }

    /** Sentences about sensors that are not simulated one by one, and the half-minute complaints, are left out. */
    private static java.util.Optional<Answer> text(String text, long at) {
        for (String other : List.of("EKF3", "EKF primary", "SIM ", "AHRS", "GPS 1: detected", "PreArm: ")) {
            if (text.startsWith(other)) {
                return java.util.Optional.empty();
            }
        }
        return java.util.Optional.of(new Answer("text", text.replaceAll("used .*", "used"), at));
    }

    /** One flat JSON object a line. */
    record JsonLine(java.util.Map<String, String> fields) {
        private static final java.util.regex.Pattern FIELD =
                java.util.regex.Pattern.compile("\"(\\w+)\": (?:\"([^\"]*)\"|([^,}\\[]+))");

        static List<JsonLine> read(Path file) throws IOException {
            return Files.readAllLines(file).stream().map(JsonLine::parse).toList();
        }

        private static JsonLine parse(String line) {
            java.util.Map<String, String> fields = new java.util.HashMap<>();
            var matcher = FIELD.matcher(line);
            while (matcher.find()) {
                fields.put(matcher.group(1), matcher.group(2) != null ? matcher.group(2) : matcher.group(3));
            }
            return new JsonLine(fields);
        }

        String text(String name) {
            return fields.getOrDefault(name, "");
        }

        long integer(String name) {
            return (long) Double.parseDouble(fields.get(name));
        }

        float number(String name) {
            String value = fields.getOrDefault(name, "0");
            return value.equals("null") ? Float.NaN : Float.parseFloat(value);
        }
    }
}

package org.dronemap.sim;

import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItem;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionItemReached;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.Statustext;

/** What a vehicle answered, recorded or simulated, in one form: kind, text, and when it came. */
record VehicleAnswer(String kind, String text, long millis) {
    /** Beginnings of sentences that are not compared: sensors that are not simulated one by one, the half-minute complaints. */
    static final List<String> LEFT_OUT = List.of(
            "EKF2",
            "EKF3",
            "EKF primary",
            "SIM ",
            "AHRS",
            "GPS 1: detected",
            "Barometer ",
            "Airspeed 1 calibrat",
            "Throttle failsafe off",
            "PreArm: ",
            "ArduPilot Ready",
            "INS: ",
            "RC7: ",
            "Field Elevation Set");

    /** Beginnings of sentences whose figures are measured ones: the words alone are compared. */
    private static final Pattern MEASURED = Pattern.compile(
            "^(Takeoff |Holding course|Armed AUTO|Triggered AUTO|Flare |Distance from LAND|Landing approach"
                    + "|Landing glide|VTOL |Transition |Battery \\d is).*");

    private static final Pattern FIGURE = Pattern.compile("-?\\d+(\\.\\d+)?");
    private static final Pattern DISTANCE = Pattern.compile(" dist \\d+m$");

    String line() {
        return kind + " " + text;
    }

    static Optional<VehicleAnswer> fromRecording(RecordedLine l) {
        long at = l.integer("t_ms");
        return switch (l.text("msg")) {
            case "COMMAND_ACK" -> ack(l.integer("command"), l.integer("result"), at);
            case "HEARTBEAT" -> Optional.of(new VehicleAnswer("mode", "" + l.integer("custom_mode"), at));
            case "STATUSTEXT" -> text(l.text("text"), at);
            case "MISSION_ACK" -> Optional.of(new VehicleAnswer("mission", "ack " + l.integer("type"), at));
            case "MISSION_COUNT" -> Optional.of(new VehicleAnswer("mission", "count " + l.integer("count"), at));
            case "MISSION_REQUEST" -> Optional.of(new VehicleAnswer("mission", "ask " + l.integer("seq"), at));
            case "MISSION_ITEM", "MISSION_ITEM_INT" ->
                Optional.of(new VehicleAnswer("mission", l.text("msg") + " " + l.integer("seq"), at));
            case "MISSION_ITEM_REACHED" -> Optional.of(new VehicleAnswer("mission", "reached " + l.integer("seq"), at));
            default -> Optional.empty();
        };
    }

    static Optional<VehicleAnswer> fromVehicle(VehicleTestBench.Heard heard, long start) {
        var f = heard.frame();
        long at = heard.millis() - start;
        return switch (f.messageId()) {
            case CommandAck.ID ->
                ack(CommandAck.decode(f).command(), CommandAck.decode(f).result(), at);
            case Heartbeat.ID ->
                Optional.of(new VehicleAnswer("mode", "" + Heartbeat.decode(f).customMode(), at));
            case Statustext.ID -> text(Statustext.decode(f).text(), at);
            case MissionAck.ID ->
                Optional.of(new VehicleAnswer(
                        "mission", "ack " + MissionAck.decode(f).type(), at));
            case MissionCount.ID ->
                Optional.of(new VehicleAnswer(
                        "mission", "count " + MissionCount.decode(f).count(), at));
            case MissionRequest.ID ->
                Optional.of(new VehicleAnswer(
                        "mission", "ask " + MissionRequest.decode(f).seq(), at));
            case MissionItem.ID ->
                Optional.of(new VehicleAnswer(
                        "mission", "MISSION_ITEM " + MissionItem.decode(f).seq(), at));
            case MissionItemInt.ID ->
                Optional.of(new VehicleAnswer(
                        "mission",
                        "MISSION_ITEM_INT " + MissionItemInt.decode(f).seq(),
                        at));
            case MissionItemReached.ID ->
                Optional.of(new VehicleAnswer(
                        "mission", "reached " + MissionItemReached.decode(f).seq(), at));
            default -> Optional.empty();
        };
    }

    private static Optional<VehicleAnswer> ack(long command, long result, long at) {
        return Optional.of(new VehicleAnswer("ack", command + " " + result, at));
    }

    private static Optional<VehicleAnswer> text(String text, long at) {
        for (String other : LEFT_OUT) {
            if (text.startsWith(other)) {
                return Optional.empty();
            }
        }
        String told = MEASURED.matcher(text).matches() ? FIGURE.matcher(text).replaceAll("#") : text;
        return Optional.of(new VehicleAnswer("text", DISTANCE.matcher(told).replaceAll(" dist"), at));
    }
}

package org.dronemap.sim;

import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionClearAll;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequest;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.mavlink.message.MissionRequestList;
import org.dronemap.mavlink.message.MissionSetCurrent;
import org.dronemap.mavlink.message.SetMode;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;

/** Says to a vehicle on the bench what the ground station of a recording said. */
final class GroundStationReplayer {
    private GroundStationReplayer() {}

    /** RC_CHANNELS_OVERRIDE of the throttle alone. */
    record Throttle(int microseconds) implements Message {
        private static final int UNCHANGED = 65_535;

        @Override
        public int messageId() {
            return 70;
        }

        @Override
        public void write(PayloadWriter out) {
            for (int channel = 1; channel <= 8; channel++) {
                out.u16(channel == 3 ? microseconds : UNCHANGED);
            }
            out.u8(1);
            out.u8(1);
        }
    }

    static void say(VehicleTestBench bench, RecordedLine l) {
        switch (l.text("msg")) {
            case "HEARTBEAT" -> bench.send(new Heartbeat(6, 8, 0, 0, 4, 3));
            case "PARAM_SET" -> bench.parameter(l.text("param_id"), l.number("param_value"));
            case "COMMAND_LONG" -> bench.send(commandLong(l));
            case "COMMAND_INT" -> bench.send(commandInt(l));
            case "SET_POSITION_TARGET_GLOBAL_INT" -> bench.send(target(l));
            case "SET_MODE" -> bench.send(new SetMode(1, (int) l.integer("base_mode"), l.integer("custom_mode")));
            case "MISSION_COUNT" -> bench.send(new MissionCount(1, 1, (int) l.integer("count"), missionType(l)));
            case "MISSION_ITEM_INT" -> bench.send(item(l));
            case "MISSION_REQUEST_LIST" -> bench.send(new MissionRequestList(1, 1, missionType(l)));
            case "MISSION_REQUEST_INT" ->
                bench.send(new MissionRequestInt(1, 1, (int) l.integer("seq"), missionType(l)));
            case "MISSION_REQUEST" -> bench.send(new MissionRequest(1, 1, (int) l.integer("seq"), 0));
            case "MISSION_SET_CURRENT" -> bench.send(new MissionSetCurrent(1, 1, (int) l.integer("seq")));
            case "RC_CHANNELS_OVERRIDE" -> bench.send(new Throttle((int) l.integer("chan3_raw")));
            case "MISSION_CLEAR_ALL" -> bench.send(new MissionClearAll(1, 1, missionType(l)));
            case "MISSION_ACK" -> bench.send(new MissionAck(1, 1, 0, 0));
            default -> throw new IllegalArgumentException("a message that the test cannot say: " + l.text("msg"));
        }
    }

    private static int missionType(RecordedLine l) {
        return (int) l.number("mission_type");
    }

    private static CommandLong commandLong(RecordedLine l) {
        return new CommandLong(
                (int) l.integer("target_system"),
                (int) l.integer("target_component"),
                (int) l.integer("command"),
                0,
                l.number("param1"),
                l.number("param2"),
                l.number("param3"),
                l.number("param4"),
                l.number("param5"),
                l.number("param6"),
                l.number("param7"));
    }

    private static CommandInt commandInt(RecordedLine l) {
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

    private static SetPositionTargetGlobalInt target(RecordedLine l) {
        return new SetPositionTargetGlobalInt(
                0,
                1,
                1,
                6,
                (int) l.integer("type_mask"),
                (int) l.integer("lat_int"),
                (int) l.integer("lon_int"),
                l.number("alt"),
                l.number("vx"),
                l.number("vy"),
                l.number("vz"),
                0,
                0,
                0,
                l.number("yaw"),
                0);
    }

    static MissionItemInt item(RecordedLine l) {
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
                missionType(l));
    }
}

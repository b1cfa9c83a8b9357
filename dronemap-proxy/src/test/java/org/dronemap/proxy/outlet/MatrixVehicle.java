package org.dronemap.proxy.outlet;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.function.BiConsumer;
import org.dronemap.core.time.Time;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.ExtendedSysState;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.HomePosition;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionClearAll;
import org.dronemap.mavlink.message.MissionCount;
import org.dronemap.mavlink.message.MissionCurrent;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.mavlink.message.MissionRequestList;
import org.dronemap.mavlink.message.MissionSetCurrent;
import org.dronemap.mavlink.message.ParamRequestList;
import org.dronemap.mavlink.message.ParamRequestRead;
import org.dronemap.mavlink.message.ParamSet;
import org.dronemap.mavlink.message.ParamValue;
import org.dronemap.mavlink.message.VfrHud;
import org.dronemap.proxy.FakeVehicle;
import org.dronemap.proxy.endpoint.PeerHandler;

/** A copter that answers all and does nothing. Any thread. */
final class MatrixVehicle implements BiConsumer<FakeVehicle, Frame>, AutoCloseable {
    private static final float OLD = 1_500;
    private static final int RATES = 511;
    private static final int GUIDED = 4;
    private static final int LOITER = 5;
    private static final int PORT = 14_551;
    private static final int CLOUD = 255;
    private static final int CLOUDS_COMPONENT = 190;
    private static final int DENIED = 2;
    private static final int MISSION_DENIED = 14;
    private static final int LATITUDE = 473_977_420;
    private static final int LONGITUDE = 85_455_940;

    private final FakeVehicle played;
    private final int parameters;

    /** How it is when something is asked of it. */
    enum State {
        DISARMED,
        ARMED,
        FLYING,
        /** In the air, in a mode that goes by sticks. */
        STEERED;

        boolean flies() {
            return this == FLYING || this == STEERED;
        }
    }

    /** On a link in memory, in that time. */
    MatrixVehicle(PeerHandler.Factory handlers, Time time) {
        this(handlers, time, 1);
    }

    /** One with so many parameters. */
    MatrixVehicle(PeerHandler.Factory handlers, Time time, int parameters) {
        this.parameters = parameters;
        played = new FakeVehicle(
                handlers, PORT, time, new FrameWriter(1, 1, 2), FakeVehicle.copter(GUIDED, false), this);
    }

    /** All that came in at it, oldest first. */
    List<Frame> heard() {
        return played.heard();
    }

    void is(State state) {
        boolean flying = state.flies();
        played.is(FakeVehicle.copter(state == State.STEERED ? LOITER : GUIDED, state != State.DISARMED));
        played.send(new HomePosition(LATITUDE, LONGITUDE, 488_000, 0, 0, 0, new float[] {1, 0, 0, 0}, 0, 0, 0, 0));
        played.send(new VfrHud(0, 0, 20, 0, 90, 0));
        played.send(new ExtendedSysState(0, flying ? 2 : 1));
        played.send(new GlobalPositionInt(
                0, LATITUDE, LONGITUDE, flying ? 508_000 : 488_000, flying ? 20_000 : 0, 0, 0, 0, 0));
    }

    @Override
    public void accept(FakeVehicle vehicle, Frame frame) {
        switch (frame.messageId()) {
            case CommandLong.ID -> answer(vehicle, CommandLong.decode(frame).command());
            case CommandInt.ID -> answer(vehicle, CommandInt.decode(frame).command());
            case ParamRequestList.ID -> list(vehicle);
            case ParamRequestRead.ID ->
                tell(vehicle, ParamRequestRead.decode(frame).paramId(), OLD, 0);
            case ParamSet.ID -> {
                ParamSet set = ParamSet.decode(frame);
                tell(vehicle, set.paramId(), set.paramValue(), 0);
            }
            case MissionRequestList.ID -> {
                int kind = MissionRequestList.decode(frame).missionType();
                vehicle.send(new MissionCount(CLOUD, CLOUDS_COMPONENT, kind == 0 ? 2 : 0, kind));
            }
            case MissionRequestInt.ID -> item(vehicle, MissionRequestInt.decode(frame));
            case MissionSetCurrent.ID ->
                vehicle.send(new MissionCurrent(MissionSetCurrent.decode(frame).seq(), 2, 0, 0));
            case MissionCount.ID -> deny(vehicle, MissionCount.decode(frame).missionType());
            case MissionClearAll.ID ->
                deny(vehicle, MissionClearAll.decode(frame).missionType());
            default -> {
                // Nothing else wants an answer.
            }
        }
    }

    private void list(FakeVehicle vehicle) {
        for (int index = 0; index < parameters; index++) {
            tell(vehicle, name(index), OLD + index, index);
        }
    }

    /** Of the parameter at that place in the list, by whose order the cloud keeps it too. */
    static String name(int index) {
        return index == 0 ? "RTL_ALT" : String.format(Locale.ROOT, "SPARE_%04d", index);
    }

    private void tell(FakeVehicle vehicle, String name, float value, int index) {
        vehicle.send(new ParamValue(name, value, 9, parameters, index));
    }

    /** It says why at once, so that nobody waits for that. */
    private static void answer(FakeVehicle vehicle, int command) {
        if (command == RATES) {
            vehicle.acknowledge(command, 0);
        } else {
            vehicle.say(4, "It does nothing");
            vehicle.acknowledge(command, DENIED);
        }
    }

    private static void deny(FakeVehicle vehicle, int kind) {
        vehicle.send(new MissionAck(CLOUD, CLOUDS_COMPONENT, MISSION_DENIED, kind));
    }

    private static void item(FakeVehicle vehicle, MissionRequestInt wanted) {
        vehicle.send(new MissionItemInt(
                CLOUD,
                CLOUDS_COMPONENT,
                wanted.seq(),
                wanted.seq() == 0 ? 0 : 3,
                16,
                0,
                1,
                0,
                0,
                0,
                0,
                LATITUDE,
                LONGITUDE,
                20,
                wanted.missionType()));
    }

    @Override
    public void close() throws IOException {
        played.close();
    }
}

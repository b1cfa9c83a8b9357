package org.dronemap.ws.lab;

import java.time.Duration;
import org.dronemap.core.drone.DroneState;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;

/** A vehicle of MAVLink that does what a test tells it to, rightly or not; twice a second it says that it is there. */
public final class HoveringVehicle {
    private static final Duration RHYTHM = Duration.ofMillis(500);
    private static final int FIRST_PORT = 20_000;
    private static final int QUADROTOR = 2;
    private static final int ARDUPILOT = 3;
    private static final int CUSTOM_MODE = 1;
    private static final int ARMED = 0x80;
    private static final int ACTIVE = 4;
    private static final int STANDBY = 3;

    private final Laboratory lab;
    private final int systemId;
    private final FrameWriter writer;
    private final LabVehicleLink wire;
    private boolean armed;
    private long mode;

    /** What it makes of a frame that came to it. */
    @FunctionalInterface
    public interface Script {
        void hears(HoveringVehicle peer, Frame frame);
    }

    HoveringVehicle(Laboratory lab, int systemId, long seed, FlightFingerprint record, Script script) {
        this.lab = lab;
        this.systemId = systemId;
        this.writer = new FrameWriter(systemId, 1, 2);
        String name = "peer " + systemId;
        this.wire = new LabVehicleLink(
                name, FIRST_PORT + systemId, lab.time(), seed, record, frame -> script.hears(this, frame));
        var unused = lab.time().worker(name, 1).every(RHYTHM, RHYTHM, this::beat);
    }

    public LabVehicleLink wire() {
        return wire;
    }

    public void is(boolean nowArmed, long nowMode) {
        armed = nowArmed;
        mode = nowMode;
    }

    public long mode() {
        return mode;
    }

    public void say(Message message) {
        wire.up(writer.frame(message));
    }

    public void beat() {
        say(new Heartbeat(QUADROTOR, ARDUPILOT, CUSTOM_MODE | (armed ? ARMED : 0), mode, armed ? ACTIVE : STANDBY, 3));
    }

    /** As the server has it. */
    public DroneState state() {
        return lab.server().house().cloud().drones().stream()
                .filter(state -> state.link().key().systemId() == systemId)
                .findFirst()
                .orElseThrow(() -> new AssertionError("The server does not know it"));
    }
}

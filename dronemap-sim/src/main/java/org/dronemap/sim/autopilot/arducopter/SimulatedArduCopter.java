package org.dronemap.sim.autopilot.arducopter;

import java.util.function.Consumer;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.ManualControl;
import org.dronemap.sim.autopilot.ardupilot.ArduPilotMode;
import org.dronemap.sim.autopilot.ardupilot.ArmingChecks;
import org.dronemap.sim.autopilot.ardupilot.SimulatedArduPilot;
import org.dronemap.sim.autopilot.items.ArduPilotItemStorage;
import org.dronemap.sim.autopilot.items.MissionItemStorage;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMissionItem;
import org.dronemap.sim.flight.TextSeverity;
import org.jspecify.annotations.Nullable;

/**
 * A simulated ArduCopter: arming checks, flight modes and fail-safes. Orders are taken apart by {@link CopterCommands}.
 */
public final class SimulatedArduCopter extends SimulatedArduPilot {
    private static final MissionItemStorage ITEMS = ArduPilotItemStorage.of("copter");
    private static final long FIRMWARE = 4L << 24 | 5 << 16 | 5 << 8 | 255;
    private static final long LANDED_DISARM_MILLIS = 400;

    private final CopterFlight flight;
    private final CopterCommands orders;
    private final CopterFailsafes failsafes;
    private final ArmingChecks checks;
    private long idleSince;
    private long landedSince;

    /** {@code modeAnnouncer} is called when the mode has changed: the heartbeat does not wait for its second */
    public SimulatedArduCopter(
            SimulatedCraft craft,
            int systemId,
            Consumer<FlightEvent> events,
            Consumer<Message> out,
            Runnable modeAnnouncer) {
        super(
                craft,
                CopterParameters.defaults(systemId, craft.battery().capacityMilliampHours()),
                events,
                out,
                modeAnnouncer);
        this.flight = new CopterFlight(craft, plan(), parameters(), returnPath(), rallyPoints(), events);
        this.failsafes = new CopterFailsafes(this, battery());
        this.checks = new CopterChecks(this, battery());
        this.orders = new CopterCommands(this, flight);
    }

    @Override
    protected CopterFlight flight() {
        return flight;
    }

    @Override
    protected CopterCommands orders() {
        return orders;
    }

    @Override
    protected CopterFailsafes failsafes() {
        return failsafes;
    }

    @Override
    protected ArmingChecks checks() {
        return checks;
    }

    @Override
    protected @Nullable CopterMode modeOf(long number) {
        return CopterMode.of(number);
    }

    @Override
    protected String armedText() {
        return "Arming motors";
    }

    @Override
    protected String disarmedText() {
        return "Disarming motors";
    }

    @Override
    protected String notArmable(ArduPilotMode mode) {
        return mode.name() + " mode not armable";
    }

    @Override
    protected void armed() {
        idleSince = now();
        landedSince = now();
    }

    @Override
    protected boolean mayDisarm() {
        return craft().landed();
    }

    @Override
    protected void disarmWhenIdle() {
        if (!craft().armed() || !craft().landed()) {
            idleSince = now();
            landedSince = now();
            return;
        }
        if (flight.takingOff()) {
            idleSince = now();
        }
        if (!flight.hasLanded()) {
            landedSince = now();
        }
        long delay = (long) (parameters().value("DISARM_DELAY") * 1000);
        boolean tooLong = delay > 0 && now() - idleSince >= delay;
        if (tooLong || now() - landedSince >= LANDED_DISARM_MILLIS) {
            disarmNow();
        }
    }

    @Override
    protected boolean enter(ArduPilotMode mode) {
        if (craft().armed() && mode.needsPosition() && !craft().navigation().hasEstimate()) {
            return refuse(mode, "requires position");
        }
        if (mode == CopterMode.AUTO && craft().armed()) {
            if (flight.mission().isEmpty()) {
                return refuse(mode, "init failed");
            }
            if (craft().landed() && !flight.mission().startsWith(SimulatedMissionItem.TAKEOFF)) {
                sendText(TextSeverity.CRITICAL, "Auto: Missing Takeoff Cmd");
                return refuse(mode, "init failed");
            }
        }
        if (mode == CopterMode.SMART_RTL && craft().armed() && !returnPath().isKnown()) {
            return refuse(mode, "init failed");
        }
        flight.enter((CopterMode) mode);
        return true;
    }

    private boolean refuse(ArduPilotMode mode, String why) {
        sendText(TextSeverity.WARNING, "Mode change to " + mode.name() + " failed: " + why);
        return false;
    }

    @Override
    public void manual(ManualControl sticks, int fromSystem) {
        if (fromSystem == (int) parameters().value("SYSID_MYGCS")) {
            flight.joystick().set(sticks, now());
        }
    }

    @Override
    public Heartbeat heartbeat() {
        int base = 81 | (flight.mode().guidedFlag ? 8 : 0) | (craft().armed() ? 128 : 0);
        int status = craft().landed() ? 3 : 4;
        return new Heartbeat(2, 3, base, flight.mode().number(), failsafes.any() ? 5 : status, 3);
    }

    @Override
    public int landedState() {
        // Disarmed it takes itself for landed, wherever it is.
        if (!craft().armed()
                || craft().landed()
                || (flight.takingOff() && craft().body().onGround())) {
            return 1;
        }
        return flight.takingOff() ? 3 : flight.landing() ? 4 : 2;
    }

    @Override
    public MissionItemStorage missionItems() {
        return ITEMS;
    }

    @Override
    public String reachedText(int index) {
        int command = index < plan().size() ? plan().item(index).command() : 0;
        boolean told = command == SimulatedMissionItem.WAYPOINT || command == SimulatedMissionItem.LOITER_TIME;
        return told ? "Reached command #" + index : "";
    }

    @Override
    public long firmware() {
        return FIRMWARE;
    }
}

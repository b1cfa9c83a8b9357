package org.dronemap.sim.autopilot.ardurover;

import java.util.function.Consumer;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.sim.autopilot.ardupilot.ArduPilotMode;
import org.dronemap.sim.autopilot.ardupilot.ArmingChecks;
import org.dronemap.sim.autopilot.ardupilot.SimulatedArduPilot;
import org.dronemap.sim.autopilot.items.ArduPilotItemStorage;
import org.dronemap.sim.autopilot.items.MissionItemStorage;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.TextSeverity;
import org.dronemap.sim.physics.LocalFrame;
import org.jspecify.annotations.Nullable;

/**
 * A simulated ArduRover: a ground vehicle that never tells whether it is landed, and that stays armed wherever it stands.
 * Its home is where its first fix was, at the height that its barometer began with, until it is moved: it may read as
 * hundreds of metres above it.
 */
public final class SimulatedArduRover extends SimulatedArduPilot {
    private static final MissionItemStorage ITEMS = ArduPilotItemStorage.of("rover");
    private static final long FIRMWARE = 4L << 24 | 5 << 16 | 6 << 8 | 255;
    private static final int GROUND_ROVER = 10;
    private static final int SURFACE_BOAT = 11;
    private static final int ARDUPILOT = 3;
    private static final int STANDBY = 3;
    private static final int ACTIVE = 4;
    private static final int CRITICAL = 5;
    private static final long HOME_MILLIS = 1_000;
    private static final double HOME_METERS = 0.5;

    private final RoverFlight flight;
    private final RoverCommands orders;
    private final RoverFailsafes failsafes;
    private final RoverArmingChecks checks;
    private long homeLookedAt = -HOME_MILLIS;
    private boolean homeSet;

    /** {@code modeAnnouncer} is called when the mode has changed: the heartbeat does not wait for its second */
    public SimulatedArduRover(
            SimulatedCraft craft,
            int systemId,
            Consumer<FlightEvent> events,
            Consumer<Message> out,
            Runnable modeAnnouncer) {
        super(
                craft,
                RoverParameters.defaults(systemId, craft.battery().capacityMilliampHours()),
                events,
                out,
                modeAnnouncer);
        this.flight = new RoverFlight(craft, plan(), parameters(), returnPath(), rallyPoints(), events);
        this.failsafes = new RoverFailsafes(this, battery());
        this.checks = new RoverArmingChecks(craft, parameters(), plan(), battery());
        this.orders = new RoverCommands(this, flight);
    }

    @Override
    public void step(long nowMillis, double seconds) {
        super.step(nowMillis, seconds);
        RoverMode next = flight.pollModeAtEnd();
        if (next != null) {
            change(next);
        }
    }

    @Override
    protected RoverFlight flight() {
        return flight;
    }

    @Override
    protected RoverCommands orders() {
        return orders;
    }

    @Override
    protected RoverFailsafes failsafes() {
        return failsafes;
    }

    @Override
    protected ArmingChecks checks() {
        return checks;
    }

    @Override
    protected @Nullable RoverMode modeOf(long number) {
        return RoverMode.of(number);
    }

    @Override
    protected boolean enter(ArduPilotMode mode) {
        if (craft().armed() && mode.needsPosition() && !craft().navigation().hasEstimate()) {
            return refuse();
        }
        if (mode == RoverMode.AUTO && flight.mission().isEmpty()) {
            sendText(TextSeverity.NOTICE, "No Mission. Can't set AUTO.");
            return refuse();
        }
        if (mode == RoverMode.SMART_RTL && craft().armed() && !returnPath().isKnown()) {
            return refuse();
        }
        flight.enter((RoverMode) mode);
        return true;
    }

    private boolean refuse() {
        sendText(TextSeverity.WARNING, "Flight mode change failed");
        return false;
    }

    @Override
    protected String armedText() {
        return "Throttle armed";
    }

    @Override
    protected String disarmedText() {
        return "Throttle disarmed";
    }

    @Override
    protected String notArmable(ArduPilotMode mode) {
        return "Mode not armable";
    }

    /** On the way too: it rolls out. */
    @Override
    protected boolean mayDisarm() {
        return true;
    }

    /** It never does. */
    @Override
    protected void disarmWhenIdle() {}

    @Override
    protected boolean setsHomeWhenArmed() {
        return false;
    }

    /** Home follows it while it is disarmed. */
    @Override
    protected void keepHome() {
        if (craft().armed()
                || now() - homeLookedAt < HOME_MILLIS
                || !craft().navigation().hasFix()) {
            return;
        }
        homeLookedAt = now();
        double moved = craft().body().position().horizontalDistanceTo(craft().homePosition());
        if (homeSet && moved < HOME_METERS) {
            return;
        }
        homeSet = true;
        craft().setHomeHere();
        if (!craft().navigation().hasOrigin()) {
            LocalFrame here = craft().home();
            craft().setHome(new LocalFrame(here.latitude(), here.longitude(), 0));
        }
        orders.sendHome();
    }

    @Override
    public Heartbeat heartbeat() {
        RoverMode mode = flight.mode();
        int base = 1 | (mode.bySticks() ? 64 : 0) | (mode.byItself() ? 8 : 0) | (craft().armed() ? 128 : 0);
        int type = flight.isBoat() ? SURFACE_BOAT : GROUND_ROVER;
        int status = mode == RoverMode.HOLD ? STANDBY : ACTIVE;
        return new Heartbeat(type, ARDUPILOT, base, mode.number(), failsafes.any() ? CRITICAL : status, 3);
    }

    /** A ground vehicle has no such state: undefined. */
    @Override
    public int landedState() {
        return 0;
    }

    @Override
    public MissionItemStorage missionItems() {
        return ITEMS;
    }

    @Override
    public long firmware() {
        return FIRMWARE;
    }
}

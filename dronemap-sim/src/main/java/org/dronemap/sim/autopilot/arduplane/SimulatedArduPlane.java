package org.dronemap.sim.autopilot.arduplane;

import java.util.Locale;
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
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.flight.TextSeverity;
import org.jspecify.annotations.Nullable;

/**
 * A simulated ArduPlane: it cannot stop in the air, takes off by the mode TAKEOFF or by a mission, and lands by a
 * mission alone. Orders are taken apart by {@link PlaneCommands}.
 */
public final class SimulatedArduPlane extends SimulatedArduPilot {
    private static final MissionItemStorage ITEMS = ArduPilotItemStorage.of("plane");
    private static final long FIRMWARE = 4L << 24 | 5 << 16 | 6 << 8 | 255;
    private static final int TYPE_FIXED_WING = 1;
    private static final int ARMED_FLAG = 128;
    private static final int STANDBY = 3;
    private static final int ACTIVE = 4;
    private static final int CRITICAL = 5;
    private static final int ON_GROUND = 1;
    private static final int IN_AIR = 2;
    private static final int COMPLETE = 5;

    private final PlaneFlight flight;
    private final PlaneCommands orders;
    private final PlaneFailsafes failsafes;
    private final ArmingChecks checks;

    /** {@code modeAnnouncer} is called when the mode has changed: the heartbeat does not wait for its second */
    public SimulatedArduPlane(
            SimulatedCraft craft,
            int systemId,
            Consumer<FlightEvent> events,
            Consumer<Message> out,
            Runnable modeAnnouncer) {
        this(craft, parameters(craft, systemId, false), events, out, modeAnnouncer, false);
    }

    private SimulatedArduPlane(
            SimulatedCraft craft,
            SimulatedParameters parameters,
            Consumer<FlightEvent> events,
            Consumer<Message> out,
            Runnable modeAnnouncer,
            boolean lifts) {
        super(craft, parameters, events, out, modeAnnouncer);
        this.flight = new PlaneFlight(craft, plan(), parameters, rallyPoints(), events, this::change, lifts);
        this.failsafes = new PlaneFailsafes(this, battery());
        this.checks = new PlaneArmingChecks(craft, parameters(), plan(), battery(), flight);
        this.orders = new PlaneCommands(this, flight);
    }

    /** One with lift motors beside its wings: a QuadPlane. */
    public static SimulatedArduPlane quadPlane(
            SimulatedCraft craft,
            int systemId,
            Consumer<FlightEvent> events,
            Consumer<Message> out,
            Runnable modeAnnouncer) {
        return new SimulatedArduPlane(craft, parameters(craft, systemId, true), events, out, modeAnnouncer, true);
    }

    private static SimulatedParameters parameters(SimulatedCraft craft, int systemId, boolean lifts) {
        return PlaneParameters.defaults(systemId, craft.battery().capacityMilliampHours(), lifts);
    }

    @Override
    protected PlaneFlight flight() {
        return flight;
    }

    @Override
    protected PlaneCommands orders() {
        return orders;
    }

    @Override
    protected PlaneFailsafes failsafes() {
        return failsafes;
    }

    @Override
    protected ArmingChecks checks() {
        return checks;
    }

    @Override
    protected @Nullable PlaneMode modeOf(long number) {
        return PlaneMode.of(number);
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
        return mode.name() + " mode not armable";
    }

    @Override
    protected boolean mayDisarm() {
        return !flight.flies();
    }

    /** It has lift motors. */
    boolean canLift() {
        return flight.lift() != null;
    }

    /** NAV_TAKEOFF, which lift motors alone can follow. */
    boolean liftOff(double metersAboveHome) {
        if (!canLift()) {
            return false;
        }
        String wrong = flight.mode() != PlaneMode.GUIDED
                ? "User Takeoff only in GUIDED mode"
                : !craft().armed() ? "Must be armed for takeoff" : flight.flies() ? "Already flying - no takeoff" : "";
        if (!wrong.isEmpty()) {
            sendText(TextSeverity.INFO, wrong);
            return false;
        }
        flight.climbTo(metersAboveHome);
        sendText(TextSeverity.INFO, "VTOL Position1 d=0.0");
        return true;
    }

    @Override
    protected void disarmWhenIdle() {
        PlaneLift lift = flight.lift();
        if (lift != null && craft().armed() && lift.landed()) {
            sendText(TextSeverity.INFO, "Land complete");
            disarmNow();
            return;
        }
        PlaneLanding landing = flight.landing();
        if (landing == null || !craft().armed() || !landing.flared() || flight.flies()) {
            return;
        }
        long delay = (long) (parameters().value("LAND_DISARMDELAY") * 1000);
        if (delay > 0 && flight.estimate().stillFor(now()) >= delay) {
            disarmNow();
            sendText(TextSeverity.INFO, "Auto disarmed");
            double meters = landing.metersFromPlace(craft().body().position());
            sendText(TextSeverity.INFO, String.format(Locale.ROOT, "Distance from LAND point=%.2fm", meters));
        }
    }

    @Override
    protected boolean enter(ArduPilotMode mode) {
        PlaneMode wanted = (PlaneMode) mode;
        if (wanted.lifts() && !canLift()) {
            sendText(TextSeverity.INFO, "Q_ENABLE 0");
            return false;
        }
        if (wanted == PlaneMode.AUTO && flight.mission().isEmpty()) {
            sendText(TextSeverity.INFO, "Mission complete, changing mode to RTL");
            wanted = PlaneMode.RTL;
        }
        flight.enter(wanted);
        return true;
    }

    @Override
    public MissionItemStorage missionItems() {
        return ITEMS;
    }

    @Override
    public int currentItem() {
        // After its last item it goes on telling that one.
        return missionState() == COMPLETE ? plan().size() - 1 : super.currentItem();
    }

    @Override
    public Heartbeat heartbeat() {
        int base = flight.mode().baseMode() | (craft().armed() ? ARMED_FLAG : 0);
        int status = flight.flies() ? ACTIVE : STANDBY;
        return new Heartbeat(TYPE_FIXED_WING, 3, base, flight.mode().number(), failsafes.any() ? CRITICAL : status, 3);
    }

    @Override
    public int landedState() {
        return flight.flies() ? IN_AIR : ON_GROUND;
    }

    @Override
    public int vtolState() {
        PlaneLift lift = flight.lift();
        return lift == null ? 0 : lift.vtolState();
    }

    @Override
    public long firmware() {
        return FIRMWARE;
    }
}

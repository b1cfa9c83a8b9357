package org.dronemap.sim.autopilot.arducopter;

import java.util.List;
import java.util.function.Consumer;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.ManualControl;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;
import org.dronemap.sim.autopilot.MavCommand;
import org.dronemap.sim.autopilot.MissionProtocolStyle;
import org.dronemap.sim.autopilot.SimulatedAutopilot;
import org.dronemap.sim.autopilot.SimulatedCommandResult;
import org.dronemap.sim.autopilot.SimulatedPayload;
import org.dronemap.sim.autopilot.items.ArduPilotItemStorage;
import org.dronemap.sim.autopilot.items.MissionItemStorage;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMission;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.flight.TextSeverity;

/**
 * A simulated ArduCopter: arming checks, flight modes and fail-safes. Orders are taken apart by {@link CopterCommands}.
 */
public final class SimulatedArduCopter implements SimulatedAutopilot {
    private static final MissionItemStorage ITEMS = ArduPilotItemStorage.of("copter");
    private static final MissionProtocolStyle STYLE =
            new MissionProtocolStyle(true, true, false, 1_000, 8_000, 650, true);
    private static final long FIRMWARE = 4L << 24 | 5 << 16 | 5 << 8 | 255;
    private static final long LANDED_DISARM_MILLIS = 400;
    private static final long PREARM_TEXT_MILLIS = 30_000;

    private final SimulatedCraft craft;
    private final SimulatedParameters parameters;
    private final SimulatedMission plan = new SimulatedMission();
    private final SimulatedPayload payload = new SimulatedPayload();
    private final Consumer<FlightEvent> events;
    private final CopterFlight flight;
    private final CopterCommands orders;
    private final BatteryFailsafe battery;
    private final CopterFailsafes failsafes;
    private final ArmingChecks checks;
    private final Runnable modeAnnouncer;
    private long now;
    private long idleSince;
    private long landedSince;
    private long complaintsReportedAt;
    private boolean originReported;

    /** {@code modeAnnouncer} is called when the mode has changed: the heartbeat does not wait for its second */
    public SimulatedArduCopter(
            SimulatedCraft craft,
            int systemId,
            Consumer<FlightEvent> events,
            Consumer<Message> out,
            Runnable modeAnnouncer) {
        this.craft = craft;
        this.events = events;
        this.modeAnnouncer = modeAnnouncer;
        this.parameters = CopterParameters.defaults(systemId, craft.battery().capacityMilliampHours());
        this.flight = new CopterFlight(craft, plan, parameters, events);
        this.battery = new BatteryFailsafe(craft, parameters);
        this.failsafes = new CopterFailsafes(this, battery);
        this.checks = new ArmingChecks(craft, parameters, plan, battery);
        this.orders = new CopterCommands(this, flight, out);
    }

    @Override
    public void step(long nowMillis, double seconds) {
        now = nowMillis;
        craft.step(flight.fly(nowMillis), nowMillis, seconds);
        failsafes.check(nowMillis);
        payload.step(parameters.value("MNT1_TYPE") > 0, seconds);
        reportOrigin();
        disarmWhenIdle();
        reportComplaints();
    }

    /** Home is told once the origin stands, long before it would arm. */
    private void reportOrigin() {
        if (!originReported && craft.navigation().hasOrigin()) {
            originReported = true;
            orders.sendHome();
        }
    }

    private void disarmWhenIdle() {
        if (!craft.armed() || !craft.landed()) {
            idleSince = now;
            landedSince = now;
            return;
        }
        if (flight.takingOff()) {
            idleSince = now;
        }
        if (!flight.hasLanded()) {
            landedSince = now;
        }
        long delay = (long) (parameters.value("DISARM_DELAY") * 1000);
        boolean tooLong = delay > 0 && now - idleSince >= delay;
        if (tooLong || now - landedSince >= LANDED_DISARM_MILLIS) {
            disarmNow();
        }
    }

    private void reportComplaints() {
        if (craft.armed() || now - complaintsReportedAt < PREARM_TEXT_MILLIS) {
            return;
        }
        reportComplaintsNow();
    }

    void reportComplaintsNow() {
        complaintsReportedAt = now;
        checks.complaints(flight.mode()).forEach(text -> sendText(TextSeverity.CRITICAL, "PreArm: " + text));
    }

    SimulatedCommandResult arm(boolean force) {
        if (craft.armed()) {
            return SimulatedCommandResult.ACCEPTED;
        }
        if (!force) {
            List<String> complaints = checks.complaints(flight.mode());
            complaints.forEach(text -> sendText(TextSeverity.CRITICAL, "Arm: " + text));
            if (complaints.isEmpty() && !flight.mode().armable) {
                sendText(TextSeverity.CRITICAL, "Arm: " + flight.mode() + " mode not armable");
                return SimulatedCommandResult.FAILED;
            }
            if (!complaints.isEmpty()) {
                return SimulatedCommandResult.FAILED;
            }
        }
        if (craft.navigation().hasEstimate()) {
            craft.setHomeHere();
            orders.sendHome();
        }
        if (parameters.value("ARMING_CHECK") == 0) {
            sendText(TextSeverity.WARNING, "Warning: Arming Checks Disabled");
        }
        craft.setArmed(true);
        flight.armed();
        idleSince = now;
        landedSince = now;
        sendText(TextSeverity.INFO, "Arming motors");
        return SimulatedCommandResult.ACCEPTED;
    }

    SimulatedCommandResult disarm(boolean force) {
        if (craft.armed()) {
            if (!force && !craft.landed()) {
                return SimulatedCommandResult.FAILED;
            }
            disarmNow();
        }
        return SimulatedCommandResult.ACCEPTED;
    }

    private void disarmNow() {
        craft.setArmed(false);
        flight.disarmed();
        sendText(TextSeverity.INFO, "Disarming motors");
    }

    /** Changes the mode, or says why not. */
    boolean change(CopterMode mode) {
        if (mode == flight.mode()) {
            return true;
        }
        if (craft.armed() && mode.needsPosition && !craft.navigation().hasEstimate()) {
            return refuse(mode, "requires position");
        }
        if (mode == CopterMode.AUTO && craft.armed()) {
            if (plan.size() <= 1) {
                return refuse(mode, "init failed");
            }
            if (craft.landed() && !flight.startsWithTakeOff()) {
                sendText(TextSeverity.CRITICAL, "Auto: Missing Takeoff Cmd");
                return refuse(mode, "init failed");
            }
        }
        flight.enter(mode);
        modeAnnouncer.run();
        return true;
    }

    private boolean refuse(CopterMode mode, String why) {
        sendText(TextSeverity.WARNING, "Mode change to " + mode + " failed: " + why);
        return false;
    }

    void sendText(TextSeverity severity, String text) {
        events.accept(new FlightEvent.Text(severity, text));
    }

    CopterFlight flight() {
        return flight;
    }

    @Override
    public SimulatedCommandResult execute(MavCommand order) {
        return orders.execute(order);
    }

    @Override
    public SimulatedCommandResult setMode(int baseMode, long customMode) {
        if ((baseMode & 1) == 0) {
            return SimulatedCommandResult.DENIED;
        }
        CopterMode mode = CopterMode.of(customMode);
        if (mode == null) {
            sendText(TextSeverity.WARNING, "No such mode " + customMode);
            return SimulatedCommandResult.FAILED;
        }
        return SimulatedCommandResult.acceptedIf(change(mode));
    }

    @Override
    public boolean acknowledgesSetMode() {
        return true;
    }

    @Override
    public void steer(SetPositionTargetGlobalInt target) {
        orders.steer(target);
    }

    @Override
    public void steer(SetPositionTargetLocalNed target) {
        orders.steer(target);
    }

    @Override
    public void manual(ManualControl sticks, int fromSystem) {
        if (fromSystem == (int) parameters.value("SYSID_MYGCS")) {
            flight.joystick().set(sticks, now);
        }
    }

    @Override
    public void stick(int throttle) {
        flight.setStick(throttle);
    }

    @Override
    public void heartbeatReceived(int systemId) {
        if (systemId == (int) parameters.value("SYSID_MYGCS")) {
            failsafes.heartbeatReceived(now);
        }
    }

    @Override
    public Heartbeat heartbeat() {
        int base = 81 | (flight.mode().guidedFlag ? 8 : 0) | (craft.armed() ? 128 : 0);
        int status = craft.landed() ? 3 : 4;
        return new Heartbeat(2, 3, base, flight.mode().number, failsafes.any() ? 5 : status, 3);
    }

    @Override
    public int landedState() {
        // Disarmed it takes itself for landed, wherever it is.
        if (!craft.armed()
                || craft.landed()
                || (flight.takingOff() && craft.body().onGround())) {
            return 1;
        }
        return flight.takingOff() ? 3 : flight.landing() ? 4 : 2;
    }

    @Override
    public boolean readyToArm() {
        return checks.complaints(flight.mode()).isEmpty();
    }

    @Override
    public SimulatedCraft craft() {
        return craft;
    }

    @Override
    public SimulatedMission plan() {
        return plan;
    }

    @Override
    public SimulatedPayload payload() {
        return payload;
    }

    @Override
    public Message takePicture() {
        payload.takePicture();
        return payload.feedback(craft, now * 1_000);
    }

    @Override
    public long missionStamp() {
        return 0;
    }

    @Override
    public SimulatedParameters parameters() {
        return parameters;
    }

    @Override
    public boolean acceptsKeysWhenArmed() {
        return false;
    }

    @Override
    public boolean parametersAsBits() {
        return false;
    }

    @Override
    public void parameterChanged(String name) {
        switch (name) {
            case "SIM_GPS_DISABLE" -> craft.navigation().setReceiving(parameters.value(name) == 0);
            case "SIM_ENGINE_MUL" -> {
                if (parameters.value(name) < 0.5) {
                    craft.failMotor();
                }
            }
            case "SIM_BATT_VOLTAGE" -> battery.restartTimers();
            default -> flight.readSpeeds();
        }
    }

    @Override
    public boolean heedsEveryComponent() {
        return true;
    }

    @Override
    public SimulatedCommandResult refuseInterval(int messageId) {
        sendText(TextSeverity.INFO, "No ap_message for mavlink id (" + messageId + ")");
        return SimulatedCommandResult.DENIED;
    }

    @Override
    public MissionProtocolStyle missionStyle() {
        return STYLE;
    }

    @Override
    public MissionItemStorage missionItems() {
        return ITEMS;
    }

    @Override
    public int currentItem() {
        return flight.currentItem();
    }

    @Override
    public int missionState() {
        return flight.missionState();
    }

    @Override
    public boolean inMissionMode() {
        return flight.mode() == CopterMode.AUTO;
    }

    @Override
    public boolean setCurrentItem(int index) {
        return flight.setCurrentItem(index);
    }

    @Override
    public boolean mayClearMission() {
        return flight.missionState() != 3;
    }

    @Override
    public void missionChanged() {
        flight.missionChanged();
    }

    @Override
    public long firmware() {
        return FIRMWARE;
    }

    @Override
    public double unaskedRate(int messageId) {
        return 0;
    }
}

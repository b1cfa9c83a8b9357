package org.dronemap.sim.autopilot.ardupilot;

import java.util.List;
import java.util.function.Consumer;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.EkfStatusReport;
import org.dronemap.mavlink.message.FenceStatus;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SetPositionTargetLocalNed;
import org.dronemap.sim.autopilot.EstimatorReport;
import org.dronemap.sim.autopilot.MavCommand;
import org.dronemap.sim.autopilot.MissionProtocolStyle;
import org.dronemap.sim.autopilot.SimulatedAutopilot;
import org.dronemap.sim.autopilot.SimulatedCommandResult;
import org.dronemap.sim.autopilot.SimulatedPayload;
import org.dronemap.sim.autopilot.fence.SimulatedFence;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.ReturnPath;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMission;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.flight.TextSeverity;
import org.jspecify.annotations.Nullable;

/**
 * A simulated ArduPilot vehicle: arming, modes, missions, parameters and texts as Copter, Rover and Plane have them
 * alike. What each does in its own way it says in a subclass.
 */
public abstract class SimulatedArduPilot implements SimulatedAutopilot {
    private static final MissionProtocolStyle STYLE =
            new MissionProtocolStyle(true, true, false, 1_000, 8_000, 650, true);

    private final SimulatedCraft craft;
    private final SimulatedParameters parameters;
    private final SimulatedMission plan = new SimulatedMission();
    private final SimulatedPayload payload = new SimulatedPayload();
    private final BatteryFailsafe battery;
    private final BatteryFailsafe secondBattery;
    private final SimulatedFence fence;
    private final RallyPoints rallyPoints;
    private final PreArmTexts preArmTexts =
            new PreArmTexts(() -> checks().complaints(flight().mode()), text -> sendText(TextSeverity.CRITICAL, text));
    private final ReturnPath returnPath = new ReturnPath();
    private final Consumer<FlightEvent> events;
    private final Consumer<Message> out;
    private final Runnable modeAnnouncer;
    private long now;
    private boolean originReported;

    /** {@code modeAnnouncer} is called when the mode has changed: the heartbeat does not wait for its second */
    protected SimulatedArduPilot(
            SimulatedCraft craft,
            SimulatedParameters parameters,
            Consumer<FlightEvent> events,
            Consumer<Message> out,
            Runnable modeAnnouncer) {
        this.craft = craft;
        this.parameters = parameters;
        this.battery = new BatteryFailsafe(craft, parameters, 1);
        this.secondBattery = new BatteryFailsafe(craft, parameters, 2);
        this.fence = new SimulatedFence(craft, parameters, events);
        this.rallyPoints = new RallyPoints(craft, parameters);
        this.events = events;
        this.out = out;
        this.modeAnnouncer = modeAnnouncer;
    }

    protected abstract ArduPilotFlight flight();

    protected abstract ArduPilotCommands orders();

    protected abstract ArduPilotFailsafes failsafes();

    protected abstract ArmingChecks checks();

    /** The mode of that custom_mode; null when there is none. */
    protected abstract @Nullable ArduPilotMode modeOf(long number);

    /** Changes to another mode, or says why not. */
    protected abstract boolean enter(ArduPilotMode mode);

    /** What it says on arming. */
    protected abstract String armedText();

    /** What it says on disarming. */
    protected abstract String disarmedText();

    /** Disarms itself if this vehicle does so after a while. */
    protected abstract void disarmWhenIdle();

    @Override
    public void step(long nowMillis, double seconds) {
        now = nowMillis;
        craft.step(flight().fly(nowMillis), nowMillis, seconds);
        returnPath.step(craft);
        failsafes().check(nowMillis);
        payload.step(parameters.value("MNT1_TYPE") > 0, seconds);
        keepHome();
        disarmWhenIdle();
        preArmTexts.step(craft.armed(), now);
    }

    /** Home is told once the origin stands, long before it would arm. */
    protected void keepHome() {
        if (!originReported && craft.navigation().hasOrigin()) {
            originReported = true;
            orders().sendHome();
        }
    }

    void reportComplaintsNow() {
        preArmTexts.report(now);
    }

    SimulatedCommandResult arm(boolean force) {
        if (craft.armed()) {
            return SimulatedCommandResult.ACCEPTED;
        }
        if (!force && !passesChecks()) {
            return SimulatedCommandResult.FAILED;
        }
        if (setsHomeWhenArmed() && craft.navigation().hasEstimate()) {
            craft.setHomeHere();
            orders().sendHome();
        }
        if (parameters.value("ARMING_CHECK") == 0) {
            sendText(TextSeverity.WARNING, "Warning: Arming Checks Disabled");
        }
        craft.setArmed(true);
        returnPath.begin(craft);
        flight().armed();
        armed();
        sendText(TextSeverity.INFO, armedText());
        return SimulatedCommandResult.ACCEPTED;
    }

    private boolean passesChecks() {
        List<String> complaints = checks().complaints(flight().mode());
        complaints.forEach(text -> sendText(TextSeverity.CRITICAL, "Arm: " + text));
        if (!complaints.isEmpty()) {
            return false;
        }
        if (!flight().mode().armable()) {
            sendText(TextSeverity.CRITICAL, "Arm: " + notArmable(flight().mode()));
            return false;
        }
        return true;
    }

    /** Home is where it was armed last. */
    protected boolean setsHomeWhenArmed() {
        return true;
    }

    /** Why it is not armed in that mode. */
    protected abstract String notArmable(ArduPilotMode mode);

    /** It has just been armed. */
    protected void armed() {}

    public SimulatedCommandResult disarm(boolean force) {
        if (craft.armed()) {
            if (!force && !mayDisarm()) {
                return SimulatedCommandResult.FAILED;
            }
            disarmNow();
        }
        return SimulatedCommandResult.ACCEPTED;
    }

    /** A disarming that is not forced is carried out now. */
    protected abstract boolean mayDisarm();

    protected void disarmNow() {
        craft.setArmed(false);
        flight().disarmed();
        sendText(TextSeverity.INFO, disarmedText());
    }

    /** Changes the mode, or says why not. */
    public boolean change(ArduPilotMode mode) {
        if (mode == flight().mode()) {
            return true;
        }
        if (!enter(mode)) {
            return false;
        }
        modeAnnouncer.run();
        return true;
    }

    public void sendText(TextSeverity severity, String text) {
        events.accept(new FlightEvent.Text(severity, text));
    }

    protected void send(Message message) {
        out.accept(message);
    }

    protected BatteryFailsafe battery() {
        return battery;
    }

    /** Counts only with BATT2_MONITOR. */
    public BatteryFailsafe secondBattery() {
        return secondBattery;
    }

    @Override
    public SimulatedFence fence() {
        return fence;
    }

    @Override
    public RallyPoints rallyPoints() {
        return rallyPoints;
    }

    /** The way back to where it was armed. */
    protected ReturnPath returnPath() {
        return returnPath;
    }

    @Override
    public @Nullable Message own(int messageId) {
        return switch (messageId) {
            case EkfStatusReport.ID -> EstimatorReport.of(craft.navigation(), craft.landed());
            case FenceStatus.ID -> fence.enabled() ? fence.status() : null;
            default -> null;
        };
    }

    protected long now() {
        return now;
    }

    @Override
    public SimulatedCommandResult execute(MavCommand order) {
        return orders().execute(order);
    }

    @Override
    public SimulatedCommandResult setMode(int baseMode, long customMode) {
        if ((baseMode & 1) == 0) {
            return SimulatedCommandResult.DENIED;
        }
        ArduPilotMode mode = modeOf(customMode);
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
        orders().steer(target);
    }

    @Override
    public void steer(SetPositionTargetLocalNed target) {
        orders().steer(target);
    }

    @Override
    public void stick(int throttle) {
        flight().setStick(throttle);
    }

    @Override
    public void heartbeatReceived(int systemId) {
        if (systemId == (int) parameters.value("SYSID_MYGCS")) {
            failsafes().heartbeatReceived(now);
        }
    }

    @Override
    public boolean readyToArm() {
        return checks().complaints(flight().mode()).isEmpty();
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
            case "SIM_BATT_VOLTAGE" -> {
                battery.restartTimers();
                secondBattery.restartTimers();
            }
            case "BATT2_LOW_VOLT", "BATT2_CRT_VOLT" -> secondBattery.restartTimers();
            default -> flight().readSpeeds();
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
    public int currentItem() {
        return flight().mission().currentItem();
    }

    @Override
    public int missionState() {
        return flight().mission().state();
    }

    @Override
    public boolean inMissionMode() {
        return flight().mode().needsMission();
    }

    @Override
    public boolean setCurrentItem(int index) {
        return flight().mission().setCurrentItem(index);
    }

    @Override
    public boolean mayClearMission() {
        return !craft.armed() || !flight().mission().isActive();
    }

    @Override
    public void missionChanged() {
        flight().mission().changed();
    }

    @Override
    public double unaskedRate(int messageId) {
        return 0;
    }
}

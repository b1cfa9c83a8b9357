package org.dronemap.sim.autopilot.px4;

import java.util.function.Consumer;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Attitude;
import org.dronemap.mavlink.message.BatteryStatus;
import org.dronemap.mavlink.message.ExtendedSysState;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.GpsRawInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.HomePosition;
import org.dronemap.mavlink.message.MissionCurrent;
import org.dronemap.mavlink.message.SetPositionTargetGlobalInt;
import org.dronemap.mavlink.message.SysStatus;
import org.dronemap.mavlink.message.SystemTime;
import org.dronemap.mavlink.message.VfrHud;
import org.dronemap.sim.autopilot.FenceStorage;
import org.dronemap.sim.autopilot.MavCommand;
import org.dronemap.sim.autopilot.MissionProtocolStyle;
import org.dronemap.sim.autopilot.SimulatedAutopilot;
import org.dronemap.sim.autopilot.SimulatedCommandResult;
import org.dronemap.sim.autopilot.SimulatedPayload;
import org.dronemap.sim.autopilot.items.MissionItemStorage;
import org.dronemap.sim.autopilot.items.WholeItemStorage;
import org.dronemap.sim.flight.FlightEvent;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.SimulatedMission;
import org.dronemap.sim.flight.SimulatedParameters;
import org.dronemap.sim.flight.TextSeverity;

/** A simulated PX4 multicopter: the commands it accepts, its flight modes and fail-safes. */
public final class SimulatedPx4 implements SimulatedAutopilot {
    private static final MissionItemStorage ITEMS = new WholeItemStorage();
    private static final MissionProtocolStyle STYLE =
            new MissionProtocolStyle(false, false, true, 500, 5_000, 500, false);
    private static final long FIRMWARE = 1L << 24 | 14 << 16 | 3 << 8 | 255;

    private final SimulatedCraft craft;
    private final SimulatedParameters parameters;
    private final FenceStorage fence = FenceStorage.unheeded();
    private final FenceStorage rallyPoints = FenceStorage.unheeded();
    private final SimulatedMission plan = new SimulatedMission();
    private final SimulatedPayload payload = new SimulatedPayload();
    private final Consumer<FlightEvent> events;
    private final Runnable modeAnnouncer;
    private final Px4Flight flight;
    private final Px4Commands orders;
    private final Px4Failsafes failsafes;
    private long now;
    private long flightlessSince;
    private long missionStamp = 1;

    /** {@code modeAnnouncer} is called when the mode has changed: the heartbeat does not wait for its second */
    public SimulatedPx4(
            SimulatedCraft craft,
            int systemId,
            Consumer<FlightEvent> events,
            Consumer<Message> out,
            Runnable modeAnnouncer) {
        this.craft = craft;
        this.events = events;
        this.modeAnnouncer = modeAnnouncer;
        this.parameters = Px4Parameters.defaults(systemId);
        this.flight = new Px4Flight(craft, plan, parameters, this::handle);
        this.failsafes = new Px4Failsafes(this);
        this.orders = new Px4Commands(this, flight, out);
    }

    private void handle(FlightEvent event) {
        events.accept(event);
        if (event instanceof FlightEvent.MissionEnded && !craft.landed()) {
            flight.holdNext();
        }
    }

    @Override
    public void step(long nowMillis, double seconds) {
        now = nowMillis;
        craft.step(flight.fly(nowMillis), nowMillis, seconds);
        if (flight.pollHold()) {
            change(Px4Mode.HOLD);
        }
        failsafes.check(nowMillis);
        disarmWhenIdle();
    }

    private void disarmWhenIdle() {
        if (!craft.armed() || !craft.landed() || flight.takingOff()) {
            flightlessSince = now;
            return;
        }
        String delay = flight.hasFlown() ? "COM_DISARM_LAND" : "COM_DISARM_PRFLT";
        double seconds = parameters.value(delay);
        if (seconds > 0 && now - flightlessSince >= seconds * 1000) {
            disarmNow(flight.hasFlown() ? "Disarmed by landing" : "Disarmed by auto preflight disarming");
        }
    }

    SimulatedCommandResult arm(boolean force) {
        if (craft.armed()) {
            return SimulatedCommandResult.ACCEPTED;
        }
        if (!force && !readyToArm()) {
            sendText(TextSeverity.CRITICAL, "Preflight Fail: " + complaint());
            sendText(TextSeverity.CRITICAL, "Arming denied: Resolve system health failures first");
            return SimulatedCommandResult.TEMPORARILY_REJECTED;
        }
        if (craft.navigation().hasEstimate()) {
            craft.setHomeHere();
            orders.sendHome();
        }
        craft.setArmed(true);
        flight.armed();
        flightlessSince = now;
        sendText(TextSeverity.INFO, "Armed by external command");
        return SimulatedCommandResult.ACCEPTED;
    }

    private String complaint() {
        if (!craft.navigation().hasFix()) {
            return "GPS fix too low";
        }
        if (!craft.navigation().hasEstimate()) {
            return "No valid global position estimate";
        }
        if (craft.battery().remainingPercent() < parameters.value("BAT_CRIT_THR") * 100) {
            return "Low battery";
        }
        return craft.crashed() || craft.motorFailed() ? "Motor failure" : "";
    }

    SimulatedCommandResult disarm(boolean force) {
        if (craft.armed()) {
            if (!force && !craft.landed()) {
                sendText(TextSeverity.CRITICAL, "Disarming denied: not landed");
                return SimulatedCommandResult.TEMPORARILY_REJECTED;
            }
            disarmNow("Disarmed by external command");
        }
        return SimulatedCommandResult.ACCEPTED;
    }

    private void disarmNow(String text) {
        craft.setArmed(false);
        flight.disarmed();
        sendText(TextSeverity.INFO, text);
    }

    /** Changes the mode, or says why not. */
    boolean change(Px4Mode mode) {
        if ((mode.needsPosition && !craft.navigation().hasEstimate()) || mode == Px4Mode.OFFBOARD) {
            return refuse(mode);
        }
        if (mode == Px4Mode.MISSION && plan.size() == 0) {
            return refuse(mode);
        }
        if (mode != flight.mode()) {
            flight.enter(mode);
            modeAnnouncer.run();
        }
        return true;
    }

    private boolean refuse(Px4Mode mode) {
        sendText(TextSeverity.CRITICAL, "Switching to mode '" + mode.label + "' is currently not possible");
        return false;
    }

    void sendText(TextSeverity severity, String text) {
        events.accept(new FlightEvent.Text(severity, text));
    }

    Px4Flight flight() {
        return flight;
    }

    @Override
    public SimulatedCommandResult execute(MavCommand order) {
        return orders.execute(order);
    }

    @Override
    public SimulatedCommandResult setMode(int baseMode, long customMode) {
        return setMode(baseMode, (int) (customMode >> 16) & 0xFF, (int) (customMode >> 24) & 0xFF);
    }

    SimulatedCommandResult setMode(int baseMode, int main, int sub) {
        Px4Mode mode = Px4Mode.of(main, sub);
        if ((baseMode & 1) == 0 || mode == null) {
            return SimulatedCommandResult.UNSUPPORTED;
        }
        return changed(mode);
    }

    SimulatedCommandResult changed(Px4Mode mode) {
        return change(mode) ? SimulatedCommandResult.ACCEPTED : SimulatedCommandResult.TEMPORARILY_REJECTED;
    }

    @Override
    public boolean acknowledgesSetMode() {
        return false;
    }

    @Override
    public void steer(SetPositionTargetGlobalInt target) {
        // PX4 heeds position targets in OFFBOARD alone, which this vehicle does not offer.
    }

    @Override
    public void stick(int throttle) {
        // The pilot's modes hold the height: the stick of a PX4 vehicle springs back to its middle.
    }

    @Override
    public void heartbeatReceived(int systemId) {
        failsafes.heartbeatReceived(now);
    }

    @Override
    public Heartbeat heartbeat() {
        int base = flight.mode().baseMode() | (craft.armed() ? 128 : 0);
        int status =
                failsafes.any() ? 5 : craft.armed() ? 4 : craft.navigation().hasEstimate() ? 3 : 1;
        return new Heartbeat(2, 12, base, flight.mode().customMode(), status, 3);
    }

    @Override
    public int landedState() {
        if (craft.landed()) {
            return 1;
        }
        return flight.takingOff() ? 3 : flight.landing() ? 4 : 2;
    }

    @Override
    public boolean readyToArm() {
        return complaint().isEmpty();
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
    public Message takePicture() {
        payload.takePicture();
        return payload.captured(craft, now);
    }

    @Override
    public SimulatedPayload payload() {
        return payload;
    }

    @Override
    public long missionStamp() {
        return missionStamp;
    }

    @Override
    public SimulatedParameters parameters() {
        return parameters;
    }

    @Override
    public boolean acceptsKeysWhenArmed() {
        return true;
    }

    @Override
    public boolean parametersAsBits() {
        return true;
    }

    @Override
    public void parameterChanged(String name) {
        flight.readSpeeds();
    }

    @Override
    public boolean heedsEveryComponent() {
        return false;
    }

    @Override
    public SimulatedCommandResult refuseInterval(int messageId) {
        return SimulatedCommandResult.FAILED;
    }

    @Override
    public MissionProtocolStyle missionStyle() {
        return STYLE;
    }

    @Override
    public FenceStorage fence() {
        return fence;
    }

    @Override
    public FenceStorage rallyPoints() {
        return rallyPoints;
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
        return flight.mode() == Px4Mode.MISSION;
    }

    @Override
    public boolean setCurrentItem(int index) {
        return flight.setCurrentItem(index);
    }

    @Override
    public boolean mayClearMission() {
        return true;
    }

    @Override
    public void missionChanged() {
        missionStamp = (missionStamp * 1_103_515_245L + 12_345) & 0xFFFF_FFFFL;
        flight.missionChanged();
        if (plan.size() == 0 && inMissionMode() && !craft.landed()) {
            change(Px4Mode.HOLD);
        }
    }

    @Override
    public long firmware() {
        return FIRMWARE;
    }

    @Override
    public double unaskedRate(int messageId) {
        return switch (messageId) {
            case Attitude.ID -> 10;
            case GlobalPositionInt.ID -> 5;
            case VfrHud.ID -> 4;
            case SysStatus.ID, GpsRawInt.ID, ExtendedSysState.ID, MissionCurrent.ID, SystemTime.ID -> 1;
            case BatteryStatus.ID, HomePosition.ID -> 0.5;
            default -> 0;
        };
    }
}

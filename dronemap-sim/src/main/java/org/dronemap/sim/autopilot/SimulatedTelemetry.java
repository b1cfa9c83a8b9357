package org.dronemap.sim.autopilot;

import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Attitude;
import org.dronemap.mavlink.message.AutopilotVersion;
import org.dronemap.mavlink.message.BatteryStatus;
import org.dronemap.mavlink.message.EkfStatusReport;
import org.dronemap.mavlink.message.ExtendedSysState;
import org.dronemap.mavlink.message.FenceStatus;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.GpsRawInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.HomePosition;
import org.dronemap.mavlink.message.MissionCurrent;
import org.dronemap.mavlink.message.ServoOutputRaw;
import org.dronemap.mavlink.message.SysStatus;
import org.dronemap.mavlink.message.SystemTime;
import org.dronemap.mavlink.message.VfrHud;
import org.dronemap.mavlink.message.Wind;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.NeuPosition;
import org.dronemap.sim.physics.SensorNoise;
import org.dronemap.sim.physics.VehicleBody;
import org.jspecify.annotations.Nullable;

/** Builds the telemetry messages of a simulated vehicle from its state. */
public final class SimulatedTelemetry {
    private static final long SENSORS = 0x0021_FC2F | 0x0200_0000;
    private static final long GPS_SENSOR = 0x20;
    private static final long PREARM_CHECK = 0x1000_0000;
    private static final long FENCE = 0x0010_0000;
    private static final int QUIET_MILLIMETERS = 300;
    private static final long CAPABILITIES = 1 | 4 | 8 | 128 | 256 | 8192;

    /** The messages that flow at a rate. */
    static final int[] STREAMED = {
        GlobalPositionInt.ID,
        Attitude.ID,
        VfrHud.ID,
        SysStatus.ID,
        BatteryStatus.ID,
        GpsRawInt.ID,
        ExtendedSysState.ID,
        HomePosition.ID,
        MissionCurrent.ID,
        SystemTime.ID,
        ServoOutputRaw.ID,
        Wind.ID,
        EkfStatusReport.ID,
        FenceStatus.ID
    };

    private final SimulatedAutopilot autopilot;
    private final SimulatedCraft craft;
    private final BatteryReports batteries;
    private final int hardware;
    private final long epochMicros;

    /** {@code hardware} is the number of its board, {@code epochMicros} the UTC time of the vehicle's boot. */
    public SimulatedTelemetry(SimulatedAutopilot autopilot, int hardware, long epochMicros) {
        this.autopilot = autopilot;
        this.craft = autopilot.craft();
        this.batteries = new BatteryReports(autopilot);
        this.hardware = hardware;
        this.epochMicros = epochMicros;
    }

    /** The message of that number as of now; null when the vehicle has none such. */
    @Nullable
    Message build(int messageId, long nowMillis) {
        return switch (messageId) {
            case Heartbeat.ID -> autopilot.heartbeat();
            case SysStatus.ID -> sysStatus();
            case SystemTime.ID -> new SystemTime(epochMicros + nowMillis * 1000, nowMillis);
            case GpsRawInt.ID -> gps(nowMillis);
            case Attitude.ID -> attitude(nowMillis);
            case GlobalPositionInt.ID -> position(nowMillis);
            case MissionCurrent.ID -> missionCurrent();
            case VfrHud.ID -> hud();
            case BatteryStatus.ID -> batteries.next();
            case HomePosition.ID -> home(craft);
            case ExtendedSysState.ID -> new ExtendedSysState(autopilot.vtolState(), autopilot.landedState());
            case AutopilotVersion.ID -> version();
            case Wind.ID -> wind();
            case ServoOutputRaw.ID -> autopilot.payload().outputs(nowMillis);
            default -> autopilot.own(messageId);
        };
    }

    /** True for messages that only come once there is something to say. */
    boolean isSilent(int messageId) {
        return switch (messageId) {
            case HomePosition.ID -> !craft.navigation().hasEstimate();
            case EkfStatusReport.ID, FenceStatus.ID -> autopilot.own(messageId) == null;
            default -> false;
        };
    }

    private SysStatus sysStatus() {
        long health = SENSORS & ~GPS_SENSOR;
        if (craft.navigation().hasFix()) {
            health |= GPS_SENSOR;
        }
        if (craft.armed() || autopilot.readyToArm()) {
            health |= PREARM_CHECK;
        }
        long present = SENSORS | PREARM_CHECK;
        if (autopilot.own(FenceStatus.ID) instanceof FenceStatus fence) {
            present |= FENCE;
            health |= fence.breachStatus() == 0 ? FENCE : 0;
        }
        return new SysStatus(
                present,
                present,
                health,
                150,
                batteries.millivolts(),
                batteries.centiamperes(),
                batteries.percentOrUnknown(),
                0,
                0,
                0,
                0,
                0,
                0,
                0,
                0,
                0);
    }

    /** What it tells of its batteries. */
    BatteryReports batteries() {
        return batteries;
    }

    private GpsRawInt gps(long nowMillis) {
        boolean fix = craft.navigation().hasFix();
        VehicleBody body = craft.body();
        NeuPosition here = craft.noise().received(craft.truePosition());
        LocalFrame frame = craft.frame();
        int altitude = fix ? (int) Math.round(frame.altitudeOf(here) * 1000) : 0;
        double course = Math.toDegrees(Math.atan2(body.velocityEast(), body.velocityNorth()));
        return new GpsRawInt(
                nowMillis * 1000,
                fix ? 6 : 1,
                fix ? degrees7(frame.latitudeOf(here)) : 0,
                fix ? degrees7(frame.longitudeOf(here)) : 0,
                altitude,
                fix ? 121 : 9999,
                fix ? 200 : 9999,
                (int) Math.round(body.groundSpeed() * 100),
                (int) Math.round((course + 360) % 360 * 100),
                fix ? 10 : 0,
                altitude,
                declared(SensorNoise.DECLARED_HORIZONTAL),
                declared(SensorNoise.DECLARED_VERTICAL),
                40,
                0,
                0);
    }

    /** Millimetres. */
    private int declared(double meters) {
        return craft.noise().on() ? (int) (meters * 1000) : QUIET_MILLIMETERS;
    }

    /** Felt in flight alone, as by an estimator. */
    private Wind wind() {
        double north = craft.landed() ? 0 : craft.wind().north();
        double east = craft.landed() ? 0 : craft.wind().east();
        double from = Math.toDegrees(Math.atan2(-east, -north));
        return new Wind((float) from, (float) Math.hypot(north, east), 0);
    }

    private Attitude attitude(long nowMillis) {
        VehicleBody body = craft.body();
        return new Attitude(
                nowMillis,
                (float) body.roll(),
                (float) body.pitch(),
                (float) body.yaw(),
                (float) body.rollRate(),
                (float) body.pitchRate(),
                (float) body.yawRate());
    }

    private GlobalPositionInt position(long nowMillis) {
        VehicleBody body = craft.body();
        NeuPosition here = body.position();
        LocalFrame frame = craft.frame();
        boolean known = craft.navigation().hasFix() || craft.navigation().hasEstimate() || !craft.landed();
        return new GlobalPositionInt(
                nowMillis,
                known ? degrees7(frame.latitudeOf(here)) : 0,
                known ? degrees7(frame.longitudeOf(here)) : 0,
                (int) Math.round(frame.altitudeOf(here) * 1000),
                (int) Math.round(craft.aboveHome() * 1000),
                centimeters(body.velocityNorth()),
                centimeters(body.velocityEast()),
                centimeters(-body.velocityUp()),
                (int) Math.round(heading() * 100) % 36000);
    }

    private double heading() {
        return (Math.toDegrees(craft.body().yaw()) + 360) % 360;
    }

    private Message missionCurrent() {
        int size = autopilot.plan().size();
        int total = autopilot.missionStyle().firstItemIsHome() ? Math.max(0, size - 1) : size;
        return new MissionCurrentWithId(
                new MissionCurrent(
                        autopilot.currentItem(), total, autopilot.missionState(), autopilot.inMissionMode() ? 1 : 0),
                autopilot.missionStamp());
    }

    private VfrHud hud() {
        VehicleBody body = craft.body();
        return new VfrHud(
                (float) body.airSpeed(craft.wind()),
                (float) body.groundSpeed(),
                (int) Math.round(heading()) % 360,
                craft.armed() ? (int) Math.round(Math.min(100, body.thrust() * 36)) : 0,
                (float) craft.frame().altitudeOf(body.position()),
                (float) body.velocityUp());
    }

    /** Home and the vehicle's own frame, as HOME_POSITION wants it. */
    public static HomePosition home(SimulatedCraft craft) {
        LocalFrame home = craft.home();
        NeuPosition local = craft.homePosition();
        return new HomePosition(
                degrees7(home.latitude()),
                degrees7(home.longitude()),
                (int) Math.round(home.altitudeAmsl() * 1000),
                (float) local.north(),
                (float) local.east(),
                (float) -local.up(),
                new float[] {1, 0, 0, 0},
                0,
                0,
                0,
                0);
    }

    private AutopilotVersion version() {
        int[] uid2 = new int[18];
        long uid = 0x5D70_0000_0000_0000L | hardware;
        for (int i = 0; i < 8; i++) {
            uid2[i] = (int) (uid >>> (56 - 8 * i)) & 0xFF;
        }
        int[] custom = {'s', 'i', 'm', 'u', 'l', 'a', 't', 'e'};
        return new AutopilotVersion(
                CAPABILITIES, autopilot.firmware(), 0, 0, 0, custom, new int[8], new int[8], 0, 0, uid, uid2);
    }

    private static int degrees7(double degrees) {
        return (int) Math.round(degrees * 1e7);
    }

    private static int centimeters(double meters) {
        return (int) Math.round(meters * 100);
    }
}

package org.dronemap.sim.autopilot.arduplane;

import org.dronemap.sim.autopilot.ardupilot.ArduPilotFailsafes;
import org.dronemap.sim.autopilot.ardupilot.BatteryFailsafe;
import org.dronemap.sim.flight.SimulatedMissionItem;
import org.dronemap.sim.flight.TextSeverity;
import org.jspecify.annotations.Nullable;

/** The fail-safes of the simulated ArduPlane for its battery and the loss of its ground station. */
final class PlaneFailsafes extends ArduPilotFailsafes {
    private static final int LONG_RTL = 1;
    private static final int LONG_GLIDE = 2;
    private static final int LONG_AUTO = 4;
    private static final int ONLY_IN_AUTO = 3;
    private static final int BATTERY_RTL = 1;
    private static final int BATTERY_LAND = 2;
    private static final int BATTERY_TERMINATE = 3;
    private static final int BATTERY_QLAND = 4;

    private final SimulatedArduPlane plane;
    private final BatteryFailsafe battery;
    private boolean groundStationLost;
    /** The mode that a breach of its fence has brought it into. */
    private @Nullable PlaneMode recovers;

    PlaneFailsafes(SimulatedArduPlane plane, BatteryFailsafe battery) {
        super(plane, battery);
        this.plane = plane;
        this.battery = battery;
    }

    @Override
    public boolean any() {
        return battery.tripped() || groundStationLost;
    }

    @Override
    protected void checkOwn(long nowMillis) {
        checkGroundStation(nowMillis);
        checkFence(nowMillis);
    }

    /** FENCE_ACTION 0 tells, all others come back; on the way back from a breach there is no other. */
    private void checkFence(long nowMillis) {
        if (plane.flight().mode() != recovers) {
            recovers = null;
        }
        boolean breach = plane.fence().check(nowMillis);
        if (!breach || recovers != null || !plane.craft().armed() || isLanding()) {
            return;
        }
        plane.sendText(TextSeverity.NOTICE, "Fence Breached");
        if (plane.parameters().value("FENCE_ACTION") != 0) {
            plane.change(PlaneMode.RTL);
            recovers = plane.flight().mode();
        }
    }

    private void checkGroundStation(long nowMillis) {
        int watched = (int) plane.parameters().value("FS_GCS_ENABL");
        boolean watches =
                watched != 0 && (watched != ONLY_IN_AUTO || plane.flight().mode() == PlaneMode.AUTO);
        boolean lost =
                watches && groundStationSilent(nowMillis, plane.parameters().value("FS_LONG_TIMEOUT"));
        if (lost && !groundStationLost && !isLanding()) {
            groundStationLost = true;
            PlaneMode wanted = afterLoss(plane.flight().mode());
            plane.change(wanted);
            plane.sendText(
                    TextSeverity.WARNING,
                    "GCS Failsafe On: " + plane.flight().mode().name());
        } else if (!lost && groundStationLost) {
            groundStationLost = false;
            plane.sendText(TextSeverity.WARNING, "GCS Failsafe Off");
        }
    }

    private boolean isLanding() {
        return plane.flight().mode() == PlaneMode.AUTO
                && plane.flight().mission().flies(SimulatedMissionItem.LAND);
    }

    private PlaneMode afterLoss(PlaneMode mode) {
        int action = (int) plane.parameters().value("FS_LONG_ACTN");
        return switch (mode) {
            case QSTABILIZE, QHOVER, QLOITER -> PlaneMode.QLAND;
            case QLAND, QRTL -> mode;
            case RTL -> action == LONG_AUTO ? PlaneMode.AUTO : mode;
            case AUTO, GUIDED ->
                switch (action) {
                    case LONG_RTL -> PlaneMode.RTL;
                    case LONG_GLIDE -> PlaneMode.FLY_BY_WIRE_A;
                    case LONG_AUTO -> PlaneMode.AUTO;
                    default -> mode;
                };
            default ->
                switch (action) {
                    case LONG_GLIDE -> PlaneMode.FLY_BY_WIRE_A;
                    case LONG_AUTO -> PlaneMode.AUTO;
                    default -> PlaneMode.RTL;
                };
        };
    }

    @Override
    protected void batteryFailed(int action) {
        switch (action) {
            case BATTERY_TERMINATE -> plane.disarm(true);
            case BATTERY_RTL -> comeBack();
            case BATTERY_LAND -> landIfItCan();
            case BATTERY_QLAND -> {
                if (plane.canLift()) {
                    plane.change(PlaneMode.QLAND);
                } else {
                    landIfItCan();
                }
            }
            default -> {}
        }
    }

    /** By the landing sequence of its mission; without one it comes back. */
    private void landIfItCan() {
        boolean flown = plane.flight().mode() == PlaneMode.AUTO;
        if (!isLanding() && plane.flight().landingSequence().exists()) {
            plane.flight().landingSequence().start(flown);
            plane.change(PlaneMode.AUTO);
        } else {
            comeBack();
        }
    }

    private void comeBack() {
        if (!isLanding()) {
            plane.change(PlaneMode.RTL);
        }
    }
}

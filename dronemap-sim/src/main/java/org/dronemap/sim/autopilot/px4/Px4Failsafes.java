package org.dronemap.sim.autopilot.px4;

import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.flight.TextSeverity;

/** The fail-safes of the simulated PX4 for data link, battery or position loss. */
final class Px4Failsafes {
    private static final int RETURN_AT_CRITICAL = 3;
    private static final int LAND_AT_CRITICAL = 2;
    private static final int EXCEPT_MISSION = 1;

    private final SimulatedPx4 px4;
    private final SimulatedCraft craft;
    private long lastHeartbeatAt = -1;
    private boolean linkLost;
    private boolean acted;
    private boolean positionLost;
    private boolean hadPosition;
    private int batteryLevel;

    Px4Failsafes(SimulatedPx4 px4) {
        this.px4 = px4;
        this.craft = px4.craft();
    }

    boolean any() {
        return linkLost || positionLost || batteryLevel > 1;
    }

    void heartbeatReceived(long nowMillis) {
        lastHeartbeatAt = nowMillis;
    }

    void check(long nowMillis) {
        checkLink(nowMillis);
        checkPosition();
        checkBattery();
    }

    private void checkLink(long nowMillis) {
        int action = (int) px4.parameters().value("NAV_DLL_ACT");
        long timeout = (long) (px4.parameters().value("COM_DL_LOSS_T") * 1000);
        boolean lost = lastHeartbeatAt >= 0 && nowMillis - lastHeartbeatAt >= timeout;
        boolean acts = lost && action > 0 && craft.armed() && !craft.landed() && !goesOn();
        if (acts && !acted) {
            acted = true;
            px4.sendText(TextSeverity.WARNING, "Failsafe activated: Datalink lost");
            act(action);
        } else if (!lost && linkLost) {
            px4.sendText(TextSeverity.INFO, "Data link regained");
        }
        linkLost = lost;
        acted &= lost;
    }

    /** By COM_DLL_EXCEPT; once the mission is over, the link is missed. */
    private boolean goesOn() {
        int except = (int) px4.parameters().value("COM_DLL_EXCEPT");
        return (except & EXCEPT_MISSION) != 0 && px4.flight().mode() == Px4Mode.MISSION;
    }

    /** NAV_DLL_ACT: 1 hold, 2 return, 3 land, 5 terminate. */
    private void act(int action) {
        switch (action) {
            case 1 -> px4.change(Px4Mode.HOLD);
            case 2 -> px4.change(Px4Mode.RETURN);
            case 5 -> px4.disarm(true);
            default -> px4.change(Px4Mode.LAND);
        }
    }

    private void checkPosition() {
        boolean has = craft.navigation().hasEstimate();
        hadPosition |= has;
        boolean lost = hadPosition && !has;
        if (lost && !positionLost && craft.armed() && px4.flight().mode().needsPosition) {
            px4.sendText(TextSeverity.CRITICAL, "Failsafe activated: position estimate lost");
            px4.change(Px4Mode.LAND);
        }
        positionLost = lost;
    }

    private void checkBattery() {
        double left = craft.battery().remainingPercent() / 100;
        int level = 0;
        for (String name : new String[] {"BAT_LOW_THR", "BAT_CRIT_THR", "BAT_EMERGEN_THR"}) {
            level += left < px4.parameters().value(name) ? 1 : 0;
        }
        if (level > batteryLevel) {
            batteryFell(level);
        }
        batteryLevel = level;
    }

    private void batteryFell(int level) {
        String[] words = {"", "Low battery", "Critical battery", "Emergency battery level"};
        px4.sendText(level == 1 ? TextSeverity.WARNING : TextSeverity.CRITICAL, words[level]);
        int action = (int) px4.parameters().value("COM_LOW_BAT_ACT");
        if (level < 2 || !craft.armed() || craft.landed()) {
            return;
        }
        if (action == LAND_AT_CRITICAL || (action == RETURN_AT_CRITICAL && level == 3)) {
            px4.change(Px4Mode.LAND);
        } else if (action == RETURN_AT_CRITICAL) {
            px4.change(Px4Mode.RETURN);
        }
    }
}

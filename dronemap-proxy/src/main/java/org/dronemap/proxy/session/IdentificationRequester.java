package org.dronemap.proxy.session;

import org.dronemap.mavlink.message.AutopilotVersion;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.proxy.mavlink.procedure.MavlinkTarget;

/** Asks a vehicle for its AUTOPILOT_VERSION: a few times at once, then rarely. Owned by the lane. */
final class IdentificationRequester {
    private static final long SOON_NANOS = 400_000_000L;
    private static final long LATER_NANOS = 5_000_000_000L;
    private static final int EAGER = 3;
    private static final int ENOUGH = 8;
    private static final int REQUEST_MESSAGE = 512;
    private static final int REQUEST_CAPABILITIES = 520;

    private final MavlinkTarget target;
    private final IdentificationRateLimiter allowance;
    private int asked;
    private long lastNanos;

    IdentificationRequester(MavlinkTarget target, IdentificationRateLimiter allowance) {
        this.target = target;
        this.allowance = allowance;
    }

    /** {@code known}: it is bound to a drone, so that asking for ever leads nowhere. */
    void sendDue(long nowNanos, boolean known) {
        long pause = asked < EAGER ? SOON_NANOS : LATER_NANOS;
        if ((asked > 0 && nowNanos - lastNanos < pause) || (known && asked >= ENOUGH)) {
            return;
        }
        if (!known && !allowance.tryAcquire(nowNanos)) {
            return;
        }
        asked++;
        lastNanos = nowNanos;
        target.send(command(REQUEST_MESSAGE, AutopilotVersion.ID));
        target.send(command(REQUEST_CAPABILITIES, 1));
    }

    private CommandLong command(int number, int parameter) {
        return new CommandLong(target.systemId(), target.componentId(), number, 0, parameter, 0f, 0f, 0f, 0f, 0f, 0f);
    }
}

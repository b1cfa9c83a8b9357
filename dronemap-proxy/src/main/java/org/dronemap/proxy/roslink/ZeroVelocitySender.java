package org.dronemap.proxy.roslink;

import java.util.function.Consumer;
import org.dronemap.proxy.roslink.wire.RobotMessage;
import org.dronemap.proxy.roslink.wire.RobotOrder;

/**
 * Sends zero speeds to a ROSLink robot that is no longer steered, or just connected, until it stands still. Nothing is
 * acknowledged, so they are said quickly a few times, and then until the robot reports that it stands. Without I/O;
 * owned by the session's lane.
 */
final class ZeroVelocitySender {
    private static final long SECOND_NANOS = 1_000_000_000L;
    private static final long QUICKLY_NANOS = 90_000_000L;
    private static final long SLOWLY_NANOS = 500_000_000L;
    /** So many whatever is reported: what was under way may have been said before the last speeds were heard. */
    private static final int QUICK_TIMES = 6;
    /** Whatever brakes stands by then. */
    private static final long SHOULD_STAND_NANOS = 5 * SECOND_NANOS;

    private final Consumer<RobotOrder> send;
    private final Runnable drivesOn;
    private final long patienceNanos;
    private final boolean flies;
    private boolean wanted;
    private boolean moves;
    private boolean alarmed;
    private boolean moved;
    private int sentCount;
    private long begunNanos;
    private long sentNanos;

    /**
     * A robot that flies is left to its flight controller, for which a speed counts for moments, and never quite stands.
     *
     * @param drivesOn hears, once a time, that a robot on the ground reports to move though it has long been told to stand
     */
    ZeroVelocitySender(boolean flies, Consumer<RobotOrder> send, Runnable drivesOn) {
        this.flies = flies;
        this.send = send;
        this.drivesOn = drivesOn;
        patienceNanos = (flies ? 3 : 30) * SECOND_NANOS;
    }

    /** It has called in. */
    void calledIn(long nowNanos) {
        if (!flies) {
            begin(nowNanos);
        }
    }

    /** It was told speeds that move it. */
    void moved() {
        moved = true;
        wanted = false;
    }

    /** It shall stand, and has been told so once, if it was told to move before. */
    void stopSent(long nowNanos) {
        if (moved) {
            begin(nowNanos);
            sentCount = 1;
            sentNanos = nowNanos;
        }
    }

    /** A command says what it shall do; before a way of its own it forgets speeds, as both would move it at once. */
    void commanded(boolean stops, long nowNanos) {
        if (moved && !flies) {
            begin(nowNanos);
            sendZero(nowNanos);
        } else if (!stops) {
            wanted = false;
        }
    }

    private void begin(long nowNanos) {
        wanted = true;
        moved = false;
        moves = false;
        alarmed = false;
        sentCount = 0;
        begunNanos = nowNanos;
    }

    /** A report has come, and these are the facts with it. */
    void received(RobotMessage report, RobotStatus facts) {
        if (wanted && sentCount >= QUICK_TIMES && report instanceof RobotMessage.Motion) {
            moves = !RobotGoal.Stopped.isStill(facts);
            wanted = moves;
        }
    }

    void advance(long nowNanos) {
        if (!wanted) {
            return;
        }
        if (moves && !flies && !alarmed && nowNanos - begunNanos > SHOULD_STAND_NANOS) {
            alarmed = true;
            drivesOn.run();
        }
        if (nowNanos - begunNanos > patienceNanos) {
            wanted = false;
        } else if (sentCount == 0 || nowNanos - sentNanos > (sentCount < QUICK_TIMES ? QUICKLY_NANOS : SLOWLY_NANOS)) {
            sendZero(nowNanos);
        }
    }

    private void sendZero(long nowNanos) {
        sentCount++;
        sentNanos = nowNanos;
        send.accept(RobotOrder.Twist.STOP);
    }
}

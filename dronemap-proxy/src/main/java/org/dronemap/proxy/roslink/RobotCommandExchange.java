package org.dronemap.proxy.roslink;

import java.util.function.Consumer;
import org.dronemap.core.cloud.VehicleChannel;
import org.dronemap.core.command.Outcome;
import org.dronemap.proxy.roslink.wire.RobotMessage;
import org.dronemap.proxy.roslink.wire.RobotOrder;

/**
 * One command to a ROSLink robot, which acknowledges nothing: repeated until a later report shows the effect. Without
 * I/O; owned by the session's lane.
 */
final class RobotCommandExchange {
    /** A report that was under way when the order left says nothing of its effect. */
    private static final long UNDER_WAY_NANOS = 50_000_000L;

    private final RobotGoal aim;
    private final Consumer<RobotOrder> send;
    private final VehicleChannel.Report report;
    private final long begunNanos;
    private long sentNanos;
    private long busyNanos;
    private boolean reported;
    private boolean ended;

    RobotCommandExchange(
            RobotGoal aim, RobotStatus now, Consumer<RobotOrder> send, VehicleChannel.Report report, long nowNanos) {
        this.aim = aim;
        this.send = send;
        this.report = report;
        begunNanos = nowNanos;
        busyNanos = nowNanos;
        order(now, nowNanos);
        aim.opening().ifPresent(send);
    }

    private void order(RobotStatus facts, long nowNanos) {
        sentNanos = nowNanos;
        send.accept(aim.order(facts));
    }

    boolean isOver() {
        return ended;
    }

    /** The robot has reported that, and these are the facts with it. */
    void received(RobotMessage message, RobotStatus facts, long nowNanos) {
        boolean bears = aim.isAbout(message) && aim.isShownBy(facts);
        if (ended || !bears || nowNanos - begunNanos < UNDER_WAY_NANOS) {
            return;
        }
        if (!reported) {
            reported = true;
            report.accepted();
        }
        if (aim.isReached(facts)) {
            end(new Outcome.Succeeded());
        }
    }

    void advance(RobotStatus facts, long nowNanos) {
        if (ended) {
            return;
        }
        boolean underWay = aim.isUnderWay(facts);
        if (underWay) {
            busyNanos = nowNanos;
        }
        if (nowNanos - begunNanos > aim.patienceNanos() || nowNanos - busyNanos > aim.idlePatienceNanos()) {
            end(
                    reported
                            ? new Outcome.Failed("The robot does not report that it did: " + aim.missing(facts) + ".")
                            : new Outcome.Unknown(
                                    "The robot reported nothing that shows it, and robots acknowledge no orders."));
        } else if (nowNanos - sentNanos > aim.betweenNanos() && !underWay) {
            order(facts, nowNanos);
        }
    }

    /** Ends it without knowing what became of it. */
    void abandon(String why) {
        if (!ended) {
            end(new Outcome.Unknown(why));
        }
    }

    private void end(Outcome outcome) {
        ended = true;
        report.ended(outcome);
    }
}

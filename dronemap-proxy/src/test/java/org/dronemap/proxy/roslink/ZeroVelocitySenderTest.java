package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import org.dronemap.proxy.roslink.wire.RobotMessage;
import org.dronemap.proxy.roslink.wire.RobotMessage.Angles;
import org.dronemap.proxy.roslink.wire.RobotMessage.Triple;
import org.dronemap.proxy.roslink.wire.RobotOrder;
import org.junit.jupiter.api.Test;

/** What a robot hears that nobody steers any more, or that has just called in, whoever spoke to it before. */
class ZeroVelocitySenderTest {
    private static final long TICK = 20_000_000L;
    private static final RobotMessage MOTION = new RobotMessage.Motion(
            new Triple(0.0, 0.0, 0.0),
            new Triple(0.0, 0.0, 0.0),
            new Triple(0.0, 0.0, 0.0),
            new Angles(null, null, null));

    private final List<RobotOrder> orders = new ArrayList<>();
    private final AtomicInteger alarms = new AtomicInteger();
    private final ZeroVelocitySender rover = new ZeroVelocitySender(false, orders::add, alarms::incrementAndGet);
    private final ZeroVelocitySender drone = new ZeroVelocitySender(true, orders::add, alarms::incrementAndGet);
    private long now = -5;

    @Test
    void stopsAGroundRobotThatCallsInAtOnceAndUntilItReportsThatItStands() {
        rover.calledIn(now);
        pass(rover, 1);
        assertThat(orders).containsExactly(RobotOrder.Twist.STOP);
        pass(rover, 500);
        int before = orders.size();
        pass(rover, 100);
        assertThat(orders).as("it says nothing, and may drive").hasSizeGreaterThan(before);

        rover.received(MOTION, speed(0));
        int settled = orders.size();
        pass(rover, 200);
        assertThat(orders).hasSize(settled).containsOnly(RobotOrder.Twist.STOP);
    }

    @Test
    void believesNoReportThatMayBeOlderThanTheLastSpeeds() {
        rover.moved();
        rover.stopSent(now);
        rover.received(MOTION, speed(0));
        pass(rover, 25);

        assertThat(orders).as("five more within half a second").hasSize(5);
    }

    @Test
    void goesOnAsLongAsItReportsThatItMoves() {
        rover.moved();
        rover.stopSent(now);
        pass(rover, 30);
        int before = orders.size();
        rover.received(MOTION, speed(0.4));
        pass(rover, 60);

        assertThat(orders).hasSizeGreaterThanOrEqualTo(before + 2);
    }

    @Test
    void tellsOnceOfARobotThatDrivesOnWhateverItHears() {
        rover.moved();
        rover.stopSent(now);
        for (int report = 0; report < 12; report++) {
            pass(rover, 50);
            rover.received(MOTION, speed(0.4));
            assertThat(alarms).as("%d s", report).hasValue(report < 5 ? 0 : 1);
        }
        rover.received(MOTION, speed(0));
        rover.moved();
        rover.stopSent(now);
        pass(rover, 60);
        rover.received(MOTION, speed(0));
        pass(rover, 600);
        assertThat(alarms).hasValue(1);
    }

    @Test
    void endsWhenItNeverReportsAnything() {
        rover.moved();
        rover.stopSent(now);
        pass(rover, 31 * 50);
        int before = orders.size();
        pass(rover, 10 * 50);

        assertThat(orders).hasSize(before);
    }

    @Test
    void saysNothingAgainstWhoSteers() {
        rover.calledIn(now);
        pass(rover, 1);
        rover.moved();
        pass(rover, 100);
        assertThat(orders).hasSize(1);
    }

    @Test
    void aStickInTheMiddleIsNoStopOfItsOwn() {
        rover.stopSent(now);
        pass(rover, 100);
        assertThat(orders).isEmpty();
    }

    @Test
    void aWayOfItsOwnBeginsWithoutTheLastSpeeds() {
        rover.moved();
        rover.commanded(false, now);
        assertThat(orders).containsExactly(RobotOrder.Twist.STOP);
        pass(rover, 30);
        assertThat(orders).hasSize(6);
    }

    @Test
    void leavesADroneThatCallsInAloneAndOneThatHasAnOrder() {
        drone.calledIn(now);
        pass(drone, 10);
        assertThat(orders).isEmpty();
        drone.moved();
        drone.stopSent(now);
        drone.commanded(false, now);
        pass(drone, 200);
        assertThat(orders).isEmpty();
    }

    @Test
    void aLinkThatLosesATenthStopsItWithinHalfASecondTenThousandTimes() {
        Random chance = new Random(7);
        for (int trial = 0; trial < 10_000; trial++) {
            List<Long> heard = new ArrayList<>();
            ZeroVelocitySender stop = new ZeroVelocitySender(
                    false,
                    order -> {
                        if (chance.nextInt(10) > 0) {
                            heard.add(now);
                        }
                    },
                    alarms::incrementAndGet);
            long begun = now;
            stop.moved();
            stop.stopSent(now);
            pass(stop, 25);
            assertThat(heard).isNotEmpty();
            assertThat(heard.get(0) - begun).isLessThanOrEqualTo(25 * TICK);
        }
    }

    private void pass(ZeroVelocitySender stop, int ticks) {
        for (int tick = 0; tick < ticks; tick++) {
            now += TICK;
            stop.advance(now);
        }
    }

    private static RobotStatus speed(double metersPerSecond) {
        return RobotStatus.NONE.moving(new RobotStatus.Kinematics(0.0, 0.0, null, metersPerSecond, 0.0));
    }
}

package org.dronemap.proxy.roslink;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.dronemap.proxy.roslink.wire.Order;
import org.junit.jupiter.api.Test;

/** What a ground robot hears first, whoever spoke to it before. */
class FirstStopTest {
    private static final long TENTH = 100_000_000L;

    private final List<Order> orders = new ArrayList<>();

    @Test
    void stopsAGroundRobotThreeTimesAndNoMore() {
        FirstStop stop = new FirstStop(false, orders::add);
        stop.tick(-5);
        assertThat(orders).containsExactly(Order.Twist.STOP);
        for (int tenth = 1; tenth < 30; tenth++) {
            stop.tick(tenth * TENTH);
        }
        assertThat(orders).hasSize(3).containsOnly(Order.Twist.STOP);
    }

    @Test
    void leavesADroneAlone() {
        new FirstStop(true, orders::add).tick(TENTH);
        assertThat(orders).isEmpty();
    }

    @Test
    void saysNothingAgainstAnOrder() {
        FirstStop stop = new FirstStop(false, orders::add);
        stop.tick(TENTH);
        stop.cancel();
        stop.tick(30 * TENTH);
        assertThat(orders).hasSize(1);
    }
}

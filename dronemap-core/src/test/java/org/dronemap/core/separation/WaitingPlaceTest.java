package org.dronemap.core.separation;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import java.util.Objects;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneId;
import org.junit.jupiter.api.Test;

/** Where a drone stands that gives way: nobody may be there any more to move it out of the next one's way. */
class WaitingPlaceTest extends SeparationTestBase {
    @Test
    void ofTwoThatCrossTheOneWaitsThatStandsInNobodysWay() {
        FlyingDrone one = new FlyingDrone("a", -60, 0).to(60, 0, 20);
        FlyingDrone other = new FlyingDrone("b", 0, -60).to(0, 60, 20);
        FlyingDrone late = new FlyingDrone("c", 150, -30).to(-150, -30, 20);
        look(one, other);
        DroneId waits = orders.get(0).to();

        yielding = Map.of();
        // It comes by some 20 s later, where that one would stand.
        late.north = waits.equals(one.id) ? 0 : -40;
        late.to(-150, late.north, 20);
        look(one, other, late);
        assertThat(orders).extracting(SeparationOrder::to).isNotEmpty().doesNotContain(waits);
    }

    @Test
    void whoStandsMakesWayBeforeTheNextOneIsNear() {
        FlyingDrone one = new FlyingDrone("a", 0, 0).stands("GUIDED");
        one.step = FlightIntent.Step.FLY;
        one.to(0, 60, 20);
        one.northward = 0;
        FlyingDrone passes = new FlyingDrone("b", 20, 20).to(20, -80, 20);
        FlyingDrone next = new FlyingDrone("c", 170, 0).to(-100, 0, 20);
        yielding = Map.of(one.id, stood(passes));
        look(one, passes, next);
        assertThat(orders)
                .singleElement()
                .satisfies(order -> assertThat(order.command()).isInstanceOf(Command.GoTo.class))
                .satisfies(order -> assertThat(order.to()).isEqualTo(one.id));
    }

    /** Its operation may have sent it on in the moment in which it was told to step aside: what comes last is obeyed. */
    @Test
    void othersReckonWithOneThatMayHaveBeenSentOn() {
        FlyingDrone one = new FlyingDrone("a", 0, 0).stands("GUIDED");
        one.step = FlightIntent.Step.FLY;
        one.to(60, 0, 20);
        one.eastward = 0;
        FlyingDrone passed = new FlyingDrone("b", 0, -300).to(0, -600, 20);
        yielding = Map.of(one.id, stood(passed));
        look(one, passed);
        assertThat(Objects.requireNonNull(yielding.get(one.id)).give().clear()).isTrue();

        now = now.plusMillis(500);
        FlyingDrone flown = new FlyingDrone("c", -60, 0).to(70, 0, 20);
        flown.handling = Handling.STEERED;
        look(one, passed, flown);
        assertThat(orders).extracting(SeparationOrder::to).containsExactly(one.id);

        now = now.plusMillis(250);
        FlyingDrone crosses = new FlyingDrone("d", 40, -40).to(40, 60, 20);
        look(one, passed, flown, crosses);
        assertThat(orders).extracting(SeparationOrder::to).contains(crosses.id);
    }
}

package org.dronemap.proxy.mavlink.translate;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicBoolean;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.ReadHome;
import org.dronemap.core.drone.Position;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandInt;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.HomePosition;
import org.dronemap.proxy.mavlink.procedure.TestWire;
import org.junit.jupiter.api.Test;

class HomeExchangesTest {
    private static final Outcome DONE = new Outcome.Succeeded();
    private static final Geodetic PLACE = new Geodetic(47.5, 8.25);

    private final AutopilotTestBench bench = new AutopilotTestBench(AutopilotTestBench.ARDUCOPTER);
    private HomePosition home = at(473_977_000, 85_456_000, 488_000);
    private boolean deafForPlaces;

    private static HomePosition at(int latitudeE7, int longitudeE7, int millimeters) {
        return new HomePosition(latitudeE7, longitudeE7, millimeters, 0f, 0f, 0f, new float[4], 0f, 0f, 0f, 0L);
    }

    private void vehicle(TestWire wire, Message message) {
        if (message instanceof CommandInt order && order.command() == 179) {
            if (!deafForPlaces) {
                home = order.param1() == 1
                        ? at(470_000_000, 80_000_000, 400_000)
                        : at(order.x(), order.y(), Math.round(order.z() * 1000));
            }
            wire.answer(new CommandAck(179, 0, 0, 0, 255, 190));
        } else if (message instanceof CommandLong question && question.command() == 512) {
            wire.answer(home);
        }
    }

    private Outcome set(Geodetic point, Altitude altitude) {
        bench.wire.peer(this::vehicle);
        Outcome outcome = bench.perform(new Command.SetHome(point, altitude));
        assertThat(outcome).isNotNull();
        return outcome;
    }

    @Test
    void setsAHomeAboveSeaLevel() {
        assertThat(set(PLACE, new Altitude(510.5, Altitude.Reference.AMSL))).isEqualTo(DONE);

        assertThat(java.util.List.of(home.latitude(), home.longitude(), home.altitude()))
                .containsExactly(475_000_000, 82_500_000, 510_500);
    }

    @Test
    void turnsAnAltitudeAboveThePresentHomeIntoOneAboveSeaLevel() {
        bench.status.home(473_977_000, 85_456_000, 488);

        assertThat(set(PLACE, new Altitude(12, Altitude.Reference.HOME))).isEqualTo(DONE);
        assertThat(home.altitude()).isEqualTo(500_000);
    }

    @Test
    void sendsNothingWhenItDoesNotKnowWhatTheAltitudeIsAbove() {
        assertThat(set(PLACE, new Altitude(12, Altitude.Reference.HOME))).isInstanceOf(Outcome.Refused.class);
        assertThat(bench.wire.sent()).isEmpty();
    }

    @Test
    void makesThePresentPlaceTheHome() {
        bench.wire.peer(this::vehicle);

        assertThat(bench.perform(new Command.SetHome(null, null))).isEqualTo(DONE);
        assertThat(bench.wire.sent(CommandInt.class)).allMatch(order -> order.param1() == 1);
    }

    @Test
    void tellsWhereTheVehicleHasItsHomeWhenItSilentlyKeptAnother() {
        deafForPlaces = true;

        assertThat(set(PLACE, new Altitude(510, Altitude.Reference.AMSL)))
                .isEqualTo(new Outcome.Failed("The vehicle says that its home is 47.397700, 8.545600 at 488.0 m."));
    }

    @Test
    void doesNotTakeTheHomeBeforeThatIsStillUnderWayForARefusal() {
        HomePosition before = home;
        bench.wire.peer((wire, message) -> {
            if (message instanceof CommandLong question && question.command() == 512) {
                wire.answer(before);
            }
            vehicle(wire, message);
        });

        assertThat(bench.perform(new Command.SetHome(PLACE, new Altitude(510, Altitude.Reference.AMSL))))
                .isEqualTo(DONE);
    }

    @Test
    void ordersOnceMoreWhenAnAcknowledgementOfAnEarlierOrderPassedForOneOfThis() {
        HomePosition before = at(475_000_000, 82_500_000, 510_000);
        home = before;
        bench.status.position(new Position(new Geodetic(47, 8), 400.0, 0.0));
        AtomicBoolean lost = new AtomicBoolean();
        bench.wire.peer((wire, message) -> {
            vehicle(wire, message);
            if (message instanceof CommandInt && lost.compareAndSet(false, true)) {
                home = before;
            }
        });

        assertThat(bench.perform(new Command.SetHome(null, null))).isEqualTo(DONE);
        assertThat(home.latitude()).isEqualTo(470_000_000);
    }

    @Test
    void saysSoWhenTheHomeIsNotWhereTheVehicleIs() {
        bench.status.position(new Position(new Geodetic(46, 7), 400.0, 0.0));
        bench.wire.peer(this::vehicle);

        assertThat(bench.perform(new Command.SetHome(null, null))).isInstanceOf(Outcome.Failed.class);
    }

    @Test
    void asksForTheHome() {
        bench.wire.peer(this::vehicle);

        assertThat(bench.perform(new ReadHome())).isEqualTo(DONE);
    }
}

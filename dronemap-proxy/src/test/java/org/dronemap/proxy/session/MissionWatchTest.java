package org.dronemap.proxy.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.PayloadWriter;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.MissionAck;
import org.dronemap.mavlink.message.MissionCurrent;
import org.dronemap.mavlink.message.MissionItemInt;
import org.dronemap.mavlink.message.MissionRequestInt;
import org.dronemap.proxy.mavlink.procedure.Exchange;
import org.dronemap.proxy.mavlink.procedure.MissionVehicle;
import org.dronemap.proxy.mavlink.procedure.TestWire;
import org.dronemap.proxy.mavlink.translate.AutopilotAdapter;
import org.dronemap.proxy.mavlink.translate.VehicleStatus;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class MissionWatchTest {
    private static final Heartbeat PX4 = new Heartbeat(2, 12, 81, 0, 3, 3);

    private final TestWire wire = new TestWire();
    private final MissionVehicle vehicle = new MissionVehicle();
    private final List<DroneEvent> told = new ArrayList<>();
    private final List<List<MissionItemInt>> onWire = new ArrayList<>();
    private final MissionWatch watch =
            new MissionWatch(wire.target(), AutopilotAdapter.of(PX4), new VehicleStatus(2, 0), told::add, onWire::add);

    /** The watch as something that is under way for ever. */
    private final Exchange watching = new Exchange() {
        @Override
        public void start(long nowNanos) {
            watch.begin(nowNanos);
        }

        @Override
        public void received(org.dronemap.mavlink.Frame frame, long nowNanos) {
            watch.received(frame, nowNanos, false);
        }

        @Override
        public void advance(long nowNanos) {
            watch.advance(nowNanos, false);
        }

        @Override
        public org.dronemap.core.command.@Nullable Outcome outcome() {
            return null;
        }
    };

    /** MISSION_CURRENT of a vehicle that numbers its missions. */
    private record Stamped(long stamp) implements Message {
        @Override
        public int messageId() {
            return MissionCurrent.ID;
        }

        @Override
        public void write(PayloadWriter out) {
            new MissionCurrent(0, 0, 0, 0).write(out);
            out.u32(stamp);
        }
    }

    private void flyWith(int items) {
        vehicle.held = new ArrayList<>(
                IntStream.range(0, items).mapToObj(seq -> item(seq, 30f, 0f)).toList());
        wire.peer(vehicle::take);
        watching.start(wire.now());
        wire.run(watching, 30);
        assertThat(told).hasSize(1);
    }

    private static MissionItemInt item(int seq, float altitude, float radius) {
        return new MissionItemInt(255, 190, seq, 3, 16, 0, 1, 0f, radius, 0f, 0f, 470_000_000 + seq, 80, altitude, 0);
    }

    @Test
    void readsAgainAsSoonAsTheVehicleGivesItsMissionAnotherNumber() {
        flyWith(100);
        wire.answer(new Stamped(7));
        wire.run(watching, 1);
        vehicle.held.set(90, item(90, 31f, 0f));
        wire.answer(new Stamped(8));
        wire.run(watching, 3);

        assertThat(told).hasSize(2);
    }

    @Test
    void readsOnceMoreWhenTheMissionChangedWhileItWasRead() {
        flyWith(100);
        wire.answer(new Stamped(7));
        wire.run(watching, 1);
        wire.answer(new Stamped(8));
        wire.run(watching, 0.5);
        assertThat(wire.sent(MissionRequestInt.class)).hasSizeBetween(105, 195);
        vehicle.held.set(2, item(2, 31f, 0f));
        wire.answer(new Stamped(9));
        wire.run(watching, 8);

        assertThat(told).hasSize(2);
        assertThat(((DroneEvent.MissionRead) told.get(1)).items().get(2))
                .isNotEqualTo(((DroneEvent.MissionRead) told.get(0)).items().get(2));
    }

    @Test
    void readsAgainAsSoonAsAMissionOfSomebodyElseIsAcknowledged() {
        flyWith(5);
        vehicle.held.set(3, item(3, 31f, 0f));
        wire.answer(new MissionAck(254, 190, 0, 0));
        wire.run(watching, 3);

        assertThat(told).hasSize(2);
    }

    @Test
    void trustsTheNumberAndReadsNothingWhileItStays() {
        flyWith(100);
        wire.answer(new Stamped(7));
        wire.run(watching, 1);
        int before = wire.sent(MissionRequestInt.class).size();
        for (int second = 0; second < 100; second++) {
            wire.answer(new Stamped(7));
            wire.run(watching, 1);
        }

        assertThat(wire.sent(MissionRequestInt.class)).hasSize(before);
    }

    @Test
    void findsAChangeDeepInALongMissionOfAVehicleThatNumbersNone() {
        flyWith(100);
        vehicle.held.set(90, item(90, 31f, 0f));
        wire.run(watching, 80);

        assertThat(told).hasSize(2);
    }

    @Test
    void tellsOfAChangedSettingThatIsNoPlaceAndNoAltitude() {
        flyWith(5);
        vehicle.held.set(3, item(3, 30f, 8f));
        wire.run(watching, 60);

        assertThat(told).hasSize(2);
        assertThat(((DroneEvent.MissionRead) told.get(1)).items())
                .isEqualTo(((DroneEvent.MissionRead) told.get(0)).items());
        assertThat(((DroneEvent.MissionRead) told.get(1)).hash())
                .isNotEqualTo(((DroneEvent.MissionRead) told.get(0)).hash());
    }

    @Test
    void tellsNothingWhileNothingChanges() {
        flyWith(100);
        wire.run(watching, 120);

        assertThat(told).hasSize(1);
    }

    @Test
    void tellsWhetherAMissionHasALandingSequence() {
        vehicle.held = List.of(command(0, 16), command(1, 189), command(2, 21));
        wire.peer(vehicle::take);
        watching.start(wire.now());
        wire.run(watching, 30);

        assertThat(told)
                .singleElement()
                .isInstanceOfSatisfying(
                        DroneEvent.MissionRead.class,
                        read -> assertThat(read.landingSequence()).isTrue());
    }

    private static MissionItemInt command(int seq, int command) {
        return new MissionItemInt(255, 190, seq, 3, command, 0, 1, 0, 0, 0, 0, 473_977_000, 85_456_000, 40, 0);
    }
}

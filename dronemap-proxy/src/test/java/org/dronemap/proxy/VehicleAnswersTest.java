package org.dronemap.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.time.SteppedTime;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.GlobalPositionInt;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.SysStatus;
import org.dronemap.proxy.session.FrameTap;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** Answers of the proxy to what vehicles say and leave unsaid, in stepped time. */
class VehicleAnswersTest {
    private static final Duration PATIENCE = Duration.ofSeconds(10);
    /** Enough for anything to be taken for a drone. */
    private static final Duration LONG_ENOUGH = Duration.ofSeconds(5);

    private static final BiConsumer<FakeVehicle, Frame> SILENT = (vehicle, frame) -> {};

    private final SteppedTime time = new SteppedTime(Instant.parse("2026-03-04T05:06:07Z"));
    private final TestCloud cloud = new TestCloud(componentId -> FrameTap.NONE, time);

    @AfterEach
    void close() {
        cloud.close();
        assertThat(time.failures()).isEmpty();
    }

    private FakeVehicle played(int port, FrameWriter writer, Heartbeat first, BiConsumer<FakeVehicle, Frame> answers) {
        return new FakeVehicle(cloud.proxy().handlers(), port, time, writer, first, answers);
    }

    private FakeVehicle vehicle(int systemId, BiConsumer<FakeVehicle, Frame> answers) {
        return played(14_551, new FrameWriter(systemId, 1, 2), FakeVehicle.copter(4, false), answers);
    }

    private void await(BooleanSupplier wanted, String otherwise) {
        TestCloud.await(time, PATIENCE, wanted, () -> otherwise);
    }

    @Test
    void makesNoDroneOfGroundStationsGimbalsAndTransponders() throws IOException {
        try (FakeVehicle vehicle = vehicle(1, SILENT)) {
            vehicle.send(FakeVehicle.copter(4, false));
            try (FakeVehicle station =
                            played(14_552, new FrameWriter(255, 190, 2), new Heartbeat(6, 8, 0, 0, 4, 3), SILENT);
                    FakeVehicle gimbal =
                            played(14_553, new FrameWriter(9, 154, 2), new Heartbeat(26, 8, 0, 0, 4, 3), SILENT);
                    FakeVehicle transponder =
                            played(14_554, new FrameWriter(10, 156, 2), new Heartbeat(27, 8, 0, 0, 4, 3), SILENT)) {
                await(
                        () -> Stream.of(vehicle, station, gimbal, transponder).allMatch(FakeVehicle::isAtTheDoor),
                        "not all were heard");
                cloud.awaitDrone(state -> state.link().state() == LinkState.LIVE);
                time.advance(LONG_ENOUGH);

                assertThat(cloud.cloud().drones()).hasSize(1);
                assertThat(station.heard()).isEmpty();
                assertThat(gimbal.heard()).isEmpty();
                assertThat(transponder.heard()).isEmpty();
            }
        }
    }

    @Test
    void keepsTwoVehiclesWithOneSystemIdApartAndCommandsThemSeparately() throws IOException {
        BiConsumer<FakeVehicle, Frame> arms = FakeVehicle.onArm((vehicle, command) -> {
            vehicle.is(FakeVehicle.copter(4, true));
            vehicle.acknowledge(FakeVehicle.ARM, 0);
        });
        try (FakeVehicle one = vehicle(1, arms);
                FakeVehicle other = played(14_552, new FrameWriter(1, 1, 2), FakeVehicle.copter(4, false), arms)) {
            await(() -> cloud.cloud().drones().size() == 2, "not two");
            DroneState first = cloud.awaitDrone(state -> state.armed() != null);

            assertThat(cloud.command(first.id(), new Command.Arm())).isEqualTo(new Outcome.Succeeded());
            assertThat(one.commands(FakeVehicle.ARM).size()
                            + other.commands(FakeVehicle.ARM).size())
                    .isEqualTo(1);
        }
    }

    @Test
    void actsOnceWhenTheFirstTwoAcknowledgementsAreLost() throws IOException {
        AtomicInteger acts = new AtomicInteger();
        try (FakeVehicle vehicle = vehicle(1, FakeVehicle.onArm((played, command) -> {
            if (command.confirmation() == 0) {
                acts.incrementAndGet();
            }
            if (command.confirmation() == 2) {
                played.is(FakeVehicle.copter(4, true));
                played.acknowledge(FakeVehicle.ARM, 0);
            }
        }))) {
            DroneState drone = cloud.awaitDrone(state -> state.armed() != null);

            assertThat(cloud.command(drone.id(), new Command.Arm())).isEqualTo(new Outcome.Succeeded());
            assertThat(acts).hasValue(1);
            assertThat(vehicle.commands(FakeVehicle.ARM))
                    .extracting(CommandLong::confirmation)
                    .containsExactly(0, 1, 2);
        }
    }

    @Test
    void passesTheVehiclesOwnSentenceOn() throws IOException {
        try (FakeVehicle vehicle = vehicle(1, FakeVehicle.onArm((played, command) -> {
            played.acknowledge(FakeVehicle.ARM, 4);
            played.say(2, "PreArm: the parrot is asleep 8251");
        }))) {
            DroneState drone = cloud.awaitDrone(state -> state.armed() != null);

            assertThat(cloud.command(drone.id(), new Command.Arm()))
                    .isEqualTo(new Outcome.Refused(
                            "vehicle", "PreArm: the parrot is asleep 8251", OutcomeCode.VEHICLE_FAILED));
            assertThat(vehicle.commands(FakeVehicle.ARM)).hasSize(1);
        }
    }

    @Test
    void saysHowLongAVehicleDidNotAnswer() throws IOException {
        try (FakeVehicle vehicle = vehicle(1, SILENT)) {
            DroneState drone = cloud.awaitDrone(state -> state.armed() != null);

            Outcome outcome = cloud.command(drone.id(), new Command.Arm());

            assertThat(vehicle.commands(FakeVehicle.ARM)).hasSize(9);
            assertThat(outcome).isEqualTo(new Outcome.TimedOut("No answer from the vehicle within 8 s (9 tries)."));
        }
    }

    @Test
    void showsWhatIsUnknownAsUnknown() throws IOException {
        try (FakeVehicle vehicle = vehicle(1, SILENT)) {
            vehicle.send(vehicle.heartbeat());
            vehicle.send(new GlobalPositionInt(0, 0, 0, 0, 0, 0, 0, 0, 65_535));
            vehicle.send(new SysStatus(0, 0, 0, 0, 12_600, -1, -1, 0, 0, 0, 0, 0, 0, 0, 0, 0));
            DroneState drone = cloud.awaitDrone(state -> state.battery() != null && state.position() != null);

            assertThat(drone.position().point()).isNull();
            assertThat(drone.position().altitudeAmslMeters()).isNull();
            assertThat(drone.battery().percent()).isNull();
            assertThat(drone.battery().amps()).isNull();
            assertThat(drone.battery().volts()).isEqualTo(12.6);
            assertThat(drone.readyToArm()).isNull();
        }
    }

    @Test
    void asksForRatesAndBeatsAsAGroundStation() throws IOException {
        try (FakeVehicle vehicle = vehicle(1, SILENT)) {
            await(
                    () -> vehicle.commands(511).stream().anyMatch(ask -> ask.param1() == 33 && ask.param2() == 250_000),
                    "no rate was asked");
            assertThat(vehicle.heard().stream().filter(frame -> frame.messageId() == Heartbeat.ID))
                    .isNotEmpty()
                    .allMatch(frame -> frame.systemId() == 255 && frame.componentId() == 190);
        }
    }
}

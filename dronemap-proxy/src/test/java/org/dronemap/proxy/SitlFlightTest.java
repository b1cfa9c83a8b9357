package org.dronemap.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A whole flight of a real ArduCopter in software, where {@code DRONEMAP_SITL_ARDUCOPTER} names its binary. */
class SitlFlightTest {
    private static final Geodetic HOME = new Geodetic(47.397742, 8.545594);

    @TempDir
    Path folder;

    @Test
    void fliesRealArduCopterFromArmingToLanding() throws IOException {
        String binary = System.getenv("DRONEMAP_SITL_ARDUCOPTER");
        Assumptions.assumeTrue(binary != null, "DRONEMAP_SITL_ARDUCOPTER names no ArduCopter; this flight is skipped");
        try (TestCloud cloud = new TestCloud(0)) {
            Process copter = start(binary, cloud.udpPort());
            try {
                fly(cloud);
            } finally {
                copter.destroy();
            }
        }
    }

    private Process start(String binary, int port) throws IOException {
        Path defaults = Path.of(binary).resolveSibling("copter.parm");
        File log = folder.resolve("sitl.log").toFile();
        Files.createFile(log.toPath());
        return new ProcessBuilder(
                        binary,
                        "--wipe",
                        "--model",
                        "+",
                        "--speedup",
                        "1",
                        "--defaults",
                        defaults.toString(),
                        "--home",
                        "47.397742,8.545594,488,0",
                        "--sysid",
                        "7",
                        "-I",
                        "59",
                        "--rc-in-port",
                        "15590",
                        "--serial0",
                        "udpclient:127.0.0.1:" + port,
                        "--serial1",
                        "none",
                        "--serial2",
                        "none")
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .redirectOutput(log)
                .start();
    }

    private static void fly(TestCloud cloud) {
        DroneState drone = cloud.awaitDrone(state -> state.identification().firmware() != null
                && state.capabilities().known());
        DroneId id = drone.id();
        assertThat(drone.identification().kind()).isEqualTo(VehicleKind.MULTICOPTER);
        assertThat(drone.identification().vehicle()).isEqualTo("ArduCopter");

        assertThat(cloud.command(id, new Command.Arm()))
                .isInstanceOfSatisfying(
                        Outcome.Refused.class,
                        refused -> assertThat(refused.reason()).contains("Arm"));
        until(cloud, id, 120, state -> Boolean.TRUE.equals(state.readyToArm()) && state.home() != null);

        succeeds(cloud, id, new Command.UploadMission(mission()));
        assertThat(state(cloud, id).mission().items()).hasSize(4);

        succeeds(cloud, id, new Command.SetMode("GUIDED"));
        // Its pre-arm checks are content before the position estimate that GUIDED needs is there.
        TestCloud.await(
                Duration.ofSeconds(90),
                () -> cloud.command(id, new Command.Arm()) instanceof Outcome.Succeeded,
                () -> state(cloud, id).toString());
        succeeds(cloud, id, new Command.TakeOff(10));
        until(cloud, id, 30, state -> above(state) > 9);
        Geodetic point = new Geodetic(47.397942, 8.545594);
        succeeds(cloud, id, new Command.GoTo(point, Altitude.aboveHome(12)));
        until(cloud, id, 40, state -> distance(state, point) < 2);
        succeeds(cloud, id, new Command.Hold());
        assertThat(state(cloud, id).mode()).isEqualTo("BRAKE");

        succeeds(cloud, id, new Command.StartMission(MissionCloudLossPolicy.CONTINUE));
        until(cloud, id, 120, state -> state.mission().reached().containsAll(List.of(0, 1)));
        succeeds(cloud, id, new Command.PauseMission());
        succeeds(cloud, id, new Command.StartMission(MissionCloudLossPolicy.RETURN_TO_LAUNCH));
        until(cloud, id, 180, state -> Boolean.FALSE.equals(state.armed()));
        assertThat(distance(state(cloud, id), HOME)).isLessThan(2);
        assertThat(state(cloud, id).mission().reached()).contains(2);
        assertThat(state(cloud, id).messages())
                .noneMatch(message -> message.text().contains("could not be set"));
        succeeds(cloud, id, new Command.ClearMission());
        assertThat(state(cloud, id).mission().items()).isEmpty();
    }

    private static Mission mission() {
        return new Mission(List.of(
                new MissionItem.TakeOff(15),
                waypoint(47.398042, 8.545594),
                waypoint(47.398042, 8.545994),
                new MissionItem.ReturnToLaunch()));
    }

    private static MissionItem waypoint(double latitude, double longitude) {
        return new MissionItem.Waypoint(new Geodetic(latitude, longitude), Altitude.aboveHome(15), 0);
    }

    private static void succeeds(TestCloud cloud, DroneId id, Command command) {
        assertThat(cloud.command(id, command)).as(command.summary()).isEqualTo(new Outcome.Succeeded());
    }

    private static DroneState state(TestCloud cloud, DroneId id) {
        return cloud.cloud().drone(id).orElseThrow();
    }

    private static void until(
            TestCloud cloud, DroneId id, int seconds, java.util.function.Predicate<DroneState> wanted) {
        TestCloud.await(
                Duration.ofSeconds(seconds),
                () -> wanted.test(state(cloud, id)),
                () -> state(cloud, id).toString());
    }

    private static double above(DroneState state) {
        Double above = state.position() == null ? null : state.position().altitudeAboveHomeMeters();
        return above == null ? 0 : above;
    }

    private static double distance(DroneState state, Geodetic to) {
        Geodetic point = state.position() == null ? null : state.position().point();
        return point == null ? Double.MAX_VALUE : Geodesy.distanceMeters(point, to);
    }
}

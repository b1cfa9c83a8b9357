package org.dronemap.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.MissionCloudLossPolicy;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.geo.Geodesy;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.LandingPlace;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Missions of real autopilots in software, where {@code DRONEMAP_SITL_ARDUCOPTER} and so on name their binaries. */
class SitlMissionItemsTest {
    private static final Geodetic HOME = new Geodetic(47.397742, 8.545594);
    private static final Geodetic FIELD = new Geodetic(47.398642, 8.545594);

    @TempDir
    Path folder;

    private static MissionItem waypoint(double latitude, double longitude, double height) {
        return new MissionItem.Waypoint(new Geodetic(latitude, longitude), Altitude.aboveHome(height), 0);
    }

    /** Every kind of item is held by the vehicle as it was sent, or refused before it is sent. */
    @ParameterizedTest
    @CsvSource({"arducopter, +, copter.parm, 27", "arduplane, plane, plane.parm, 28", "ardurover, rover, rover.parm, 29"
    })
    void aRealVehicleHoldsWhatItGets(String binary, String model, String defaults, int instance) throws IOException {
        try (TestCloud cloud = new TestCloud(0)) {
            Process vehicle = start(binary, model, defaults, instance, cloud.udpPort());
            try {
                DroneState drone =
                        cloud.awaitDrone(state -> state.identification().firmware() != null
                                && state.capabilities().known());
                // It has no room for a mission before it has looked at its memory.
                TestCloud.await(
                        Duration.ofSeconds(60),
                        () -> cloud.command(drone.id(), new Command.ClearMission()) instanceof Outcome.Succeeded
                                && state(cloud, drone.id()).home() != null,
                        () -> state(cloud, drone.id()).toString());
                items().forEach(item -> isHeldOrRefused(cloud, drone, item));
            } finally {
                vehicle.destroy();
            }
        }
    }

    private static List<MissionItem> items() {
        return List.of(
                new MissionItem.TakeOff(20),
                new MissionItem.Waypoint(FIELD, Altitude.aboveHome(30), 3),
                new MissionItem.Waypoint(FIELD, Altitude.aboveHome(30), 2.5),
                new MissionItem.Waypoint(FIELD, new Altitude(520.25, Altitude.Reference.AMSL), 0),
                new MissionItem.ReturnToLaunch(),
                new MissionItem.Land(),
                new MissionItem.Land(LandingPlace.levelWithHome(FIELD)),
                new MissionItem.Land(new LandingPlace(FIELD, Altitude.aboveHome(-6))),
                new MissionItem.Wait(2.5),
                new MissionItem.TakePhoto(),
                new MissionItem.SetServo(9, 1_900),
                new MissionItem.LookAt(FIELD, Altitude.aboveHome(5)),
                new MissionItem.LookAt(FIELD, new Altitude(495, Altitude.Reference.AMSL)),
                new MissionItem.LookAhead());
    }

    private static void isHeldOrRefused(TestCloud cloud, DroneState drone, MissionItem item) {
        Mission mission = new Mission(List.of(waypoint(47.402, 8.545594, 40), item));
        Outcome outcome = cloud.command(drone.id(), new Command.UploadMission(mission));
        if (drone.capabilities().missions().fault(mission).isEmpty()) {
            assertThat(outcome).as(item.toString()).isEqualTo(new Outcome.Succeeded());
            List<MissionItem> held =
                    Objects.requireNonNull(state(cloud, drone.id()).mission().items());
            assertThat(held.get(1).kind()).isEqualTo(item.kind());
        } else {
            assertThat(outcome)
                    .isInstanceOfSatisfying(
                            Outcome.Refused.class,
                            refused -> assertThat(refused.code()).isEqualTo(OutcomeCode.MISSION_NOT_FOR_VEHICLE));
        }
    }

    /** From the ground to the ground by a mission alone, on a way down that the mission gives. */
    @Test
    void aRealPlaneLandsWhereItsMissionSays() throws IOException {
        try (TestCloud cloud = new TestCloud(0)) {
            Process plane = start("arduplane", "plane", "plane.parm", 26, cloud.udpPort());
            try {
                DroneId id = cloud.awaitDrone(state -> state.identification().firmware() != null
                                && state.capabilities().known())
                        .id();
                until(cloud, id, 120, state -> Boolean.TRUE.equals(state.readyToArm()) && state.home() != null);
                succeeds(
                        cloud,
                        id,
                        new Command.UploadMission(new Mission(List.of(
                                new MissionItem.TakeOff(50),
                                waypoint(47.4040, 8.545594, 60),
                                waypoint(47.4060, 8.551, 60),
                                waypoint(47.4030, 8.551, 50),
                                new MissionItem.Land(LandingPlace.levelWithHome(new Geodetic(47.3982, 8.551)))))));
                TestCloud.await(
                        Duration.ofSeconds(90),
                        () -> cloud.command(id, new Command.Arm()) instanceof Outcome.Succeeded,
                        () -> state(cloud, id).toString());
                succeeds(cloud, id, new Command.StartMission(MissionCloudLossPolicy.CONTINUE));
                until(cloud, id, 60, state -> above(state) > 30);
                until(cloud, id, 240, state -> Boolean.FALSE.equals(state.armed()));
                assertThat(Geodesy.distanceMeters(
                                Objects.requireNonNull(state(cloud, id).position())
                                        .point(),
                                new Geodetic(47.3982, 8.551)))
                        .isLessThan(80);
            } finally {
                plane.destroy();
            }
        }
    }

    private Process start(String binary, String model, String defaults, int instance, int port) throws IOException {
        String setting = "DRONEMAP_SITL_" + binary.toUpperCase(Locale.ROOT);
        String program = System.getenv(setting);
        Assumptions.assumeTrue(program != null, setting + " names no autopilot; this flight is skipped");
        File log = folder.resolve("sitl.log").toFile();
        Files.createFile(log.toPath());
        return new ProcessBuilder(
                        program,
                        "--wipe",
                        "--model",
                        model,
                        "--speedup",
                        "1",
                        "--defaults",
                        Path.of(program).resolveSibling(defaults).toString(),
                        "--home",
                        HOME.latitudeDegrees() + "," + HOME.longitudeDegrees() + ",488,0",
                        "--sysid",
                        "7",
                        "-I",
                        String.valueOf(instance),
                        "--rc-in-port",
                        String.valueOf(15_260 + instance),
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

    private static double above(DroneState state) {
        return state.position() == null || state.position().altitudeAboveHomeMeters() == null
                ? 0
                : state.position().altitudeAboveHomeMeters();
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
}

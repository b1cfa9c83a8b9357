package org.dronemap.cognitive.cost;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.SplittableRandom;
import org.dronemap.cognitive.PlanningFixtures;
import org.dronemap.cognitive.plan.TimedPlace;
import org.dronemap.cognitive.plan.Tour;
import org.dronemap.cognitive.plan.TourLeg;
import org.dronemap.cognitive.problem.Barrier;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.IdentityTrust;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LinkStatus;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.PayloadState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.core.zone.BreachAction;
import org.dronemap.core.zone.Zone;
import org.dronemap.core.zone.ZoneBinding;
import org.dronemap.core.zone.ZoneRegistry;
import org.dronemap.core.zone.ZoneRules;
import org.dronemap.core.zone.ZoneValidity;
import org.junit.jupiter.api.Test;

/** What is planned passes the check that the command gate makes of the mission. */
class CommandGateAcceptsTest {
    private static final Instant NOW = Instant.parse("2026-05-04T10:00:00Z");
    private static final double GROUND = 400;

    @Test
    void letsEveryPlannedMissionThrough() {
        SplittableRandom random = new SplittableRandom(99);
        int flown = 0;
        for (int round = 0; round < 1_000; round++) {
            flown += fly(random, round % 2 == 0 ? 1 : 40, round) ? 1 : 0;
        }
        assertThat(flown).isGreaterThan(150);
    }

    /** {@code scale}: of all lengths, up to tens of kilometres where straight lines are bent. */
    private static boolean fly(SplittableRandom random, double scale, int round) {
        List<Zone> zones = new ArrayList<>();
        for (int i = 0; i < 6; i++) {
            zones.add(zone("z" + i, shape(random, scale), band(random)));
        }
        List<Waypoint> waypoints = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
            waypoints.add(Waypoint.at(
                    "w" + i,
                    PlanningFixtures.place(
                            scale * random.nextDouble(-300, 300),
                            scale * random.nextDouble(-300, 300),
                            random.nextDouble(430, 500))));
        }
        Craft craft = PlanningFixtures.craft(0, 0, 0);
        CostModel model = CostModel.of(PlanningProblem.of(waypoints, List.of(craft))
                .withBarriers(zones.stream().map(Barrier::of).toList()));
        Legs legs = model.instance().legs();
        double seconds = legs.seconds(0, 3, 0) + legs.seconds(0, 0, 1) + legs.seconds(0, 1, 2) + legs.seconds(0, 2, 4);
        if (seconds == Double.POSITIVE_INFINITY) {
            return false;
        }
        Tour tour = model.plan(new int[][] {{0, 1, 2}}).tours().get(0);
        ZoneRegistry book = new ZoneRegistry();
        book.put(zones);
        assertThat(new ZoneRules(book).whyNot("ann", state(craft), new Command.UploadMission(mission(tour)), NOW))
                .as("round " + round)
                .isEmpty();
        return true;
    }

    private static FenceArea shape(SplittableRandom random, double scale) {
        double x = scale * random.nextDouble(-300, 300);
        double y = scale * random.nextDouble(-300, 300);
        double radius = scale * random.nextDouble(10, 120);
        if (random.nextInt(3) == 0) {
            return new FenceArea.Circle(false, PlanningFixtures.point(x, y), radius);
        }
        List<Geodetic> corners = new ArrayList<>();
        int count = random.nextInt(3, 8);
        for (int i = 0; i < count; i++) {
            double angle = 2 * Math.PI * (i + random.nextDouble(0.8)) / count;
            double away = radius * random.nextDouble(0.4, 1);
            corners.add(PlanningFixtures.point(x + away * Math.cos(angle), y + away * Math.sin(angle)));
        }
        return new FenceArea.Polygon(false, corners);
    }

    private static AltitudeBand band(SplittableRandom random) {
        return switch (random.nextInt(4)) {
            case 0 -> new AltitudeBand(null, random.nextDouble(20, 80), Altitude.Reference.HOME);
            case 1 -> new AltitudeBand(random.nextDouble(440, 480), null, Altitude.Reference.AMSL);
            default -> AltitudeBand.ALL;
        };
    }

    private static Zone zone(String id, FenceArea shape, AltitudeBand band) {
        return new Zone(id, id, shape, band, ZoneBinding.EVERYBODY, ZoneValidity.ALWAYS, BreachAction.HOLD, "ann", NOW);
    }

    private static Mission mission(Tour tour) {
        List<MissionItem> items = new ArrayList<>();
        List<TourLeg> ways = tour.ways();
        items.add(new MissionItem.TakeOff(ways.get(0).fixes().get(1).place().altitudeAmslMeters() - GROUND));
        for (TourLeg way : ways) {
            boolean first = way.equals(ways.get(0));
            boolean last = way.equals(tour.last());
            List<TimedPlace> fixes = way.fixes();
            for (TimedPlace fix : fixes.subList(first ? 2 : 1, last ? fixes.size() - 1 : fixes.size())) {
                Altitude altitude = new Altitude(fix.place().altitudeAmslMeters(), Altitude.Reference.AMSL);
                items.add(new MissionItem.Waypoint(fix.place().point(), altitude, 0));
            }
        }
        items.add(new MissionItem.Land());
        return new Mission(items);
    }

    private static DroneState state(Craft craft) {
        Geodetic home = craft.start().place().point();
        return new DroneState(
                new DroneId("d0"),
                "Copter",
                false,
                new LinkStatus(
                        new DroneKey("127.0.0.1", 14601, 1),
                        "udp",
                        LinkState.LIVE,
                        NOW,
                        LinkQuality.UNKNOWN,
                        List.of()),
                new Identification(VehicleKind.MULTICOPTER, "ArduPilot", "ArduCopter", "4.5.6", null),
                IdentityTrust.UNPROVED,
                new Capabilities(Set.of(Capability.values()), List.of("AUTO"), Map.of()),
                "AUTO",
                false,
                true,
                FlightPhase.ON_GROUND,
                new Position(home, GROUND, 0.0),
                null,
                null,
                null,
                null,
                null,
                new Home(home, GROUND),
                null,
                PayloadState.UNKNOWN,
                MissionProgress.UNKNOWN,
                List.of(),
                NOW,
                1,
                null);
    }
}

package org.dronemap.core.zone;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dronemap.core.command.Command;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Home;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;

/** Random missions, go-tos and take-offs against random zones; each verdict is judged by geometry that is not ours. */
final class ZoneTrial {
    private final Random random;
    private int tried;
    private int accepted;
    private int clear;
    private int clearAndAccepted;

    ZoneTrial(long seed) {
        random = new Random(seed);
    }

    void run(int missions) {
        for (int i = 0; i < missions; i++) {
            Geodetic middle = middle();
            List<Zone> zones = zones(middle);
            one(onGround(middle), new Command.UploadMission(new Mission(items(middle))), zones);
            one(onGround(middle), new Command.TakeOff(random.nextDouble(5, 150)), zones);
            one(inTheAir(middle), new Command.GoTo(near(middle, 1500), altitude()), zones);
        }
        assertThat(accepted).as("some must be accepted").isGreaterThan(tried / 20);
        assertThat(tried - accepted).as("and some refused").isGreaterThan(tried / 20);
        assertThat(clearAndAccepted)
                .as("of %d missions that are clear by more than 1 m", clear)
                .isGreaterThanOrEqualTo((int) Math.ceil(clear * 0.999));
    }

    String figures() {
        return String.format(
                "%d missions, go-tos and take-offs, %d accepted; %d clear by more than 1 m, %d of them accepted",
                tried, accepted, clear, clearAndAccepted);
    }

    private void one(DroneState drone, Command command, List<Zone> zones) {
        ZoneRegistry book = new ZoneRegistry();
        book.put(zones);
        boolean taken = new ZoneRules(book)
                .whyNot("bob", drone, command, ZoneFixtures.NOW)
                .isEmpty();
        ExactZoneOracle.Expectation verdict = new ExactZoneOracle(drone).judge(command, zones);
        tried++;
        if (taken) {
            accepted++;
            assertThat(verdict.touches())
                    .as("accepted, but touches: %s at %s with %s", command, drone.position(), zones)
                    .isFalse();
        }
        if (verdict.clearByMeters() > 1) {
            clear++;
            clearAndAccepted += taken ? 1 : 0;
        }
    }

    /** Often where the date changes: otherwise it would hardly ever be met. */
    private Geodetic middle() {
        double longitude = random.nextInt(10) == 0 ? 180 : random.nextDouble(-180, 180);
        return new Geodetic(random.nextDouble(-70, 70), longitude);
    }

    private DroneState onGround(Geodetic middle) {
        Geodetic home = near(middle, 300);
        return withHome(ZoneFixtures.onGround(home), home);
    }

    private DroneState inTheAir(Geodetic middle) {
        return withHome(ZoneFixtures.flying(near(middle, 900), random.nextDouble(5, 150)), near(middle, 300));
    }

    private static DroneState withHome(DroneState some, Geodetic home) {
        return new DroneState(
                some.id(),
                some.name(),
                false,
                some.link(),
                some.identification(),
                some.standing(),
                some.capabilities(),
                some.mode(),
                some.armed(),
                true,
                some.phase(),
                some.position(),
                null,
                null,
                null,
                null,
                null,
                new Home(home, 450),
                null,
                some.payload(),
                some.mission(),
                List.of(),
                ZoneFixtures.NOW,
                1,
                null);
    }

    private List<Zone> zones(Geodetic middle) {
        List<Zone> zones = new ArrayList<>();
        int wanted = 1 + random.nextInt(3);
        while (zones.size() < wanted) {
            FenceArea shape = shape(middle);
            if (ShapeValidator.of(shape).isEmpty()) {
                zones.add(new Zone(
                        "z" + zones.size(),
                        "Z",
                        shape,
                        band(shape.inside()),
                        ZoneBinding.EVERYBODY,
                        ZoneValidity.ALWAYS,
                        BreachAction.HOLD,
                        "ann",
                        ZoneFixtures.NOW));
            }
        }
        return zones;
    }

    private FenceArea shape(Geodetic middle) {
        boolean inside = random.nextInt(5) == 0;
        double size = inside ? random.nextDouble(500, 4000) : Math.pow(10, random.nextDouble(0.3, 3.3));
        Geodetic center = near(middle, inside ? 200 : 1200);
        if (random.nextInt(3) == 0) {
            return new FenceArea.Circle(inside, center, Math.max(1, size));
        }
        int corners = 3 + random.nextInt(9);
        List<Geodetic> places = new ArrayList<>();
        for (int i = 0; i < corners; i++) {
            double angle = 2 * Math.PI * (i + random.nextDouble(0.9)) / corners;
            double far = size * random.nextDouble(0.2, 1);
            places.add(moved(center, far * Math.cos(angle), far * Math.sin(angle)));
        }
        return new FenceArea.Polygon(inside, places);
    }

    private AltitudeBand band(boolean inside) {
        Altitude.Reference reference = random.nextBoolean() ? Altitude.Reference.HOME : Altitude.Reference.AMSL;
        double zero = reference == Altitude.Reference.HOME ? 0 : 450;
        Double floor = !inside && random.nextInt(3) == 0 ? zero + random.nextDouble(0, 80) : null;
        Double ceiling = random.nextInt(3) == 0 ? zero + random.nextDouble(81, 200) : null;
        return new AltitudeBand(floor, ceiling, reference);
    }

    private List<MissionItem> items(Geodetic middle) {
        List<MissionItem> items = new ArrayList<>();
        items.add(new MissionItem.TakeOff(random.nextDouble(5, 100)));
        int waypoints = 1 + random.nextInt(6);
        for (int i = 0; i < waypoints; i++) {
            items.add(new MissionItem.Waypoint(near(middle, 1500), altitude(), 0));
        }
        if (random.nextBoolean()) {
            items.add(random.nextBoolean() ? new MissionItem.ReturnToLaunch() : new MissionItem.Land());
        }
        return items;
    }

    private Altitude altitude() {
        double height = random.nextDouble(5, 150);
        return random.nextInt(4) != 0
                ? Altitude.aboveHome(height)
                : new Altitude(450 + height, Altitude.Reference.AMSL);
    }

    private Geodetic near(Geodetic middle, double meters) {
        return moved(middle, random.nextDouble(-meters, meters), random.nextDouble(-meters, meters));
    }

    private static Geodetic moved(Geodetic from, double north, double east) {
        double across = 111_195 * Math.cos(Math.toRadians(from.latitudeDegrees()));
        double longitude = from.longitudeDegrees() + east / across;
        return new Geodetic(
                from.latitudeDegrees() + north / 111_195,
                longitude > 180 ? longitude - 360 : longitude < -180 ? longitude + 360 : longitude);
    }
}

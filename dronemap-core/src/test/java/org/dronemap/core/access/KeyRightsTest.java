package org.dronemap.core.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.Stream;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.core.zone.FlightBounds;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.locationtech.jts.geom.Coordinate;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.geom.Point;
import org.locationtech.jts.geom.Polygon;

class KeyRightsTest {
    private static final int PAIRS = 3_000;
    private static final Instant NOW = Instant.parse("2026-01-01T00:00:00Z");
    private static final List<DroneId> DRONES =
            List.of(new DroneId("d1"), new DroneId("d2"), new DroneId("d3"), new DroneId("d4"));

    private static final GeometryFactory SHAPES = new GeometryFactory();
    private static final int SIDE = 6;

    private final Random random = new Random(41);

    @Test
    void neverLetAKeyDoWhatTheOneItWasMadeFromMayNot() {
        int within = 0;
        for (int pair = 0; pair < PAIRS; pair++) {
            KeyRights parent = any();
            KeyRights child = random.nextBoolean() ? any() : lessThan(parent);
            if (child.beyond(parent).isEmpty()) {
                within++;
                assertThat(allowedOnlyTo(child, parent))
                        .as("%s made from %s", child, parent)
                        .isZero();
            }
        }
        assertThat(within).as("pairs in which the child was let pass").isBetween(PAIRS / 4, PAIRS * 3 / 4);
    }

    @Test
    void refuseAKeyOnlyForSomethingThatItWouldAddOrMightAdd() {
        for (int pair = 0; pair < PAIRS; pair++) {
            KeyRights parent = any();
            assertThat(lessThan(parent).beyond(parent)).isEmpty();
            assertThat(parent.beyond(parent)).isEmpty();
        }
    }

    @Test
    void sayWhatGoesBeyond() {
        KeyRights parent = new KeyRights(
                Role.OPERATOR, new KeyScope(Set.of(DRONES.get(0)), Set.of(Permission.COMMAND)), NOW.plusSeconds(60));

        assertThat(new KeyRights(Role.ADMINISTRATOR, parent.scope(), parent.expiresAt()).beyond(parent))
                .contains(KeyRights.Excess.ROLE);
        assertThat(new KeyRights(Role.OPERATOR, new KeyScope(null, Set.of()), parent.expiresAt()).beyond(parent))
                .contains(KeyRights.Excess.DRONES);
        assertThat(new KeyRights(Role.OPERATOR, new KeyScope(Set.of(), Set.of(Permission.PLAN)), parent.expiresAt())
                        .beyond(parent))
                .contains(KeyRights.Excess.PERMISSIONS);
        assertThat(new KeyRights(Role.OPERATOR, parent.scope(), null).beyond(parent))
                .contains(KeyRights.Excess.EXPIRY);
    }

    @Test
    void sayInWhichBoundsTheyGoBeyond() {
        KeyScope everywhere = KeyScope.ALL;
        KeyScope low = everywhere.boundedBy(new FlightBounds(null, heights(null, 50.0)));
        KeyScope near = everywhere.boundedBy(new FlightBounds(rectangle(0, 0, 5, 5), AltitudeBand.ALL));
        KeyScope lowAndNear = near.boundedBy(new FlightBounds(rectangle(0, 0, 5, 5), heights(null, 50.0)));

        assertThat(beyond(everywhere, low)).contains(KeyRights.Excess.ALTITUDE);
        assertThat(beyond(everywhere, near)).contains(KeyRights.Excess.AREA);
        assertThat(beyond(low, near)).contains(KeyRights.Excess.AREA);
        assertThat(beyond(near, lowAndNear)).contains(KeyRights.Excess.ALTITUDE);
        assertThat(beyond(near.boundedBy(new FlightBounds(rectangle(0, 0, 6, 5), AltitudeBand.ALL)), near))
                .contains(KeyRights.Excess.AREA);
        assertThat(beyond(lowAndNear, near)).isEmpty();
        assertThat(beyond(
                        everywhere.boundedBy(
                                new FlightBounds(null, new AltitudeBand(null, 40.0, Altitude.Reference.AMSL))),
                        low))
                .as("heights of another reference")
                .contains(KeyRights.Excess.ALTITUDE);
        assertThat(beyond(everywhere.boundedBy(new FlightBounds(rectangle(1, 1, 4, 4), AltitudeBand.ALL)), near))
                .as("closer bounds without those that they were made from")
                .contains(KeyRights.Excess.AREA);
    }

    private static Optional<KeyRights.Excess> beyond(KeyScope child, KeyScope parent) {
        return new KeyRights(Role.OPERATOR, child, null).beyond(new KeyRights(Role.OPERATOR, parent, null));
    }

    private int allowedOnlyTo(KeyRights child, KeyRights parent) {
        int more = allowedOnlyThere(child.scope().innermost(), parent.scope().innermost());
        for (Role needed : Role.values()) {
            for (DroneId drone : DRONES) {
                for (int second = -1; second <= 4; second++) {
                    Instant then = NOW.plusSeconds(second);
                    if (child.permit(needed, drone, then) && !parent.permit(needed, drone, then)) {
                        more++;
                    }
                }
            }
        }
        return more;
    }

    /** Places of a grid, and heights over them, at which only the first one lets fly. */
    private static int allowedOnlyThere(@Nullable FlightBounds child, @Nullable FlightBounds parent) {
        if (parent == null) {
            return 0;
        }
        Polygon inner = shape(child);
        Polygon outer = shape(parent);
        int more = 0;
        for (int north = 0; north <= 2 * SIDE; north++) {
            for (int east = 0; east <= 2 * SIDE; east++) {
                Point place = SHAPES.createPoint(coordinate(at(north / 2.0, east / 2.0)));
                for (double meters = -5; meters <= 105; meters += 10) {
                    boolean flies = isOver(inner, place) && isAt(child, meters);
                    if (flies && !(isOver(outer, place) && isAt(parent, meters))) {
                        more++;
                    }
                }
            }
        }
        return more;
    }

    private static boolean isOver(@Nullable Polygon area, Point place) {
        return area == null || area.covers(place);
    }

    private static boolean isAt(@Nullable FlightBounds bounds, double meters) {
        return bounds == null
                || (meters >= bounds.band().lowMeters()
                        && meters <= bounds.band().highMeters());
    }

    private static @Nullable Polygon shape(@Nullable FlightBounds bounds) {
        return bounds == null || !(bounds.area() instanceof FenceArea.Polygon area)
                ? null
                : SHAPES.createPolygon(Stream.concat(
                                area.corners().stream(), area.corners().stream().limit(1))
                        .map(KeyRightsTest::coordinate)
                        .toArray(Coordinate[]::new));
    }

    private static Coordinate coordinate(Geodetic place) {
        return new Coordinate(place.longitudeDegrees(), place.latitudeDegrees());
    }

    /** Parts of degrees that are exact as numbers, so that edges meet exactly. */
    private static Geodetic at(double north, double east) {
        return new Geodetic(40 + north / 16, 8 + east / 16);
    }

    private static FenceArea rectangle(int south, int west, int north, int east) {
        return new FenceArea.Polygon(true, List.of(at(south, west), at(south, east), at(north, east), at(north, west)));
    }

    private static AltitudeBand heights(@Nullable Double floor, @Nullable Double ceiling) {
        return new AltitudeBand(floor, ceiling, Altitude.Reference.HOME);
    }

    /** An area with a notch that others may reach into; null: none. */
    private @Nullable FenceArea area() {
        int south = random.nextInt(SIDE - 1);
        int west = random.nextInt(SIDE - 1);
        int north = south + 2 + random.nextInt(SIDE - south - 1);
        int east = west + 2 + random.nextInt(SIDE - west - 1);
        int depth = 1 + random.nextInt(east - west - 1);
        return switch (random.nextInt(3)) {
            case 0 -> null;
            case 1 -> rectangle(south, west, north, east);
            default ->
                new FenceArea.Polygon(
                        true,
                        List.of(
                                at(south, west),
                                at(south, east),
                                at((south + north) / 2.0, west + depth),
                                at(north, east),
                                at(north, west)));
        };
    }

    private AltitudeBand band() {
        double floor = 10 * random.nextInt(5);
        return heights(
                random.nextBoolean() ? null : floor, random.nextBoolean() ? null : floor + 10 + 10 * random.nextInt(5));
    }

    private KeyScope bounded(KeyScope scope) {
        return random.nextInt(3) == 0 ? scope : scope.boundedBy(new FlightBounds(area(), band()));
    }

    /** Bounds of its own, within those that are there already; at times the same again. */
    private KeyScope closer(KeyScope scope) {
        FlightBounds outer = scope.innermost();
        for (int attempt = 0; attempt < 5; attempt++) {
            FlightBounds own = new FlightBounds(area(), band());
            if (outer == null || own.beyond(outer).isEmpty()) {
                return scope.boundedBy(own);
            }
        }
        return scope;
    }

    private KeyRights any() {
        return new KeyRights(
                Role.values()[random.nextInt(Role.values().length)],
                bounded(new KeyScope(random.nextInt(3) == 0 ? null : some(new HashSet<>(DRONES)), some(all()))),
                random.nextInt(3) == 0 ? null : NOW.plusSeconds(random.nextInt(4)));
    }

    private KeyRights lessThan(KeyRights parent) {
        Set<DroneId> drones = parent.scope().drones();
        return new KeyRights(
                Role.values()[random.nextInt(parent.role().ordinal() + 1)],
                closer(new KeyScope(
                        drones == null && random.nextBoolean()
                                ? null
                                : some(drones == null ? new HashSet<>(DRONES) : new HashSet<>(drones)),
                        some(new HashSet<>(parent.scope().permissions())),
                        parent.scope().bounds())),
                earlier(parent.expiresAt()));
    }

    private @Nullable Instant earlier(@Nullable Instant end) {
        if (end == null) {
            return random.nextBoolean() ? null : NOW.plusSeconds(random.nextInt(4));
        }
        return end.minusSeconds(random.nextInt(2));
    }

    private <T> Set<T> some(Set<T> of) {
        of.removeIf(each -> random.nextBoolean());
        return of;
    }

    private static Set<Permission> all() {
        return new HashSet<>(EnumSet.allOf(Permission.class));
    }
}

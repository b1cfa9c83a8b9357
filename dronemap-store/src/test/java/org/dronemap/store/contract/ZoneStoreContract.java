package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.List;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.FenceArea;
import org.dronemap.core.zone.AltitudeBand;
import org.dronemap.core.zone.BreachAction;
import org.dronemap.core.zone.Zone;
import org.dronemap.core.zone.ZoneBinding;
import org.dronemap.core.zone.ZoneStore;
import org.dronemap.core.zone.ZoneValidity;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every {@link ZoneStore} keeps to. */
public abstract class ZoneStoreContract {
    private static final Instant CHANGED = Instant.parse("2026-03-04T05:06:07Z");
    private static final FenceArea AREA = new FenceArea.Polygon(
            false, List.of(new Geodetic(47.1234567, 8.5), new Geodetic(47.2, 8.5), new Geodetic(47.2, 8.6)));

    private ZoneStore store;

    /** An empty store. */
    protected abstract ZoneStore emptyStore();

    @BeforeEach
    void open() {
        store = emptyStore();
    }

    @Test
    void isEmptyAtFirst() {
        assertThat(store.zones()).isEmpty();
        assertThat(store.delete("z1")).isFalse();
    }

    @Test
    void givesBackEveryKindOfZone() {
        Zone plain = zone("z1", "a", AREA);
        Zone circle = new Zone(
                "z2",
                "b “quoted”",
                new FenceArea.Circle(true, new Geodetic(-17, 179.9), 250.5),
                new AltitudeBand(10.0, 120.5, Altitude.Reference.AMSL),
                new ZoneBinding.OfUser("bob"),
                new ZoneValidity(CHANGED, CHANGED.plusSeconds(3600)),
                BreachAction.RETURN_TO_LAUNCH,
                "alice",
                CHANGED);
        Zone ofDrone = new Zone(
                "z3",
                "c",
                AREA,
                new AltitudeBand(null, 60.0, Altitude.Reference.HOME),
                new ZoneBinding.OfDrone(new DroneId("drone-1")),
                new ZoneValidity(null, CHANGED),
                BreachAction.LAND,
                "alice",
                CHANGED);
        store.save(List.of(plain, circle, ofDrone));

        assertThat(store.zones()).containsExactly(plain, circle, ofDrone);
    }

    @Test
    void replacesAZoneOfTheSameId() {
        store.save(List.of(zone("z1", "before", AREA)));
        Zone after = zone("z1", "after", new FenceArea.Circle(false, new Geodetic(47, 8), 100));
        store.save(List.of(after));
        assertThat(store.zones()).containsExactly(after);
    }

    @Test
    void listsByNameWhateverTheCase() {
        store.save(List.of(zone("z1", "beta", AREA), zone("z2", "Gamma", AREA), zone("z3", "Alpha", AREA)));
        assertThat(store.zones()).extracting(Zone::name).containsExactly("Alpha", "beta", "Gamma");
    }

    @Test
    void deletesAndSaysWhetherThereWasOne() {
        store.save(List.of(zone("z1", "one", AREA)));
        assertThat(store.delete("z1")).isTrue();
        assertThat(store.delete("z1")).isFalse();
        assertThat(store.zones()).isEmpty();
    }

    private static Zone zone(String id, String name, FenceArea shape) {
        return new Zone(
                id,
                name,
                shape,
                AltitudeBand.ALL,
                ZoneBinding.EVERYBODY,
                ZoneValidity.ALWAYS,
                BreachAction.HOLD,
                "alice",
                CHANGED);
    }
}

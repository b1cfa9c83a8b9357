package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import java.util.Collections;
import java.util.List;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.mission.Altitude;
import org.dronemap.core.mission.Mission;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.mission.MissionStore;
import org.dronemap.core.mission.SavedMission;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every {@link MissionStore} keeps to. */
public abstract class MissionStoreContract {
    private static final Instant CHANGED = Instant.parse("2026-03-04T05:06:07Z");

    private MissionStore store;

    /** An empty store. */
    protected abstract MissionStore emptyStore();

    @BeforeEach
    void open() {
        store = emptyStore();
    }

    @Test
    void isEmptyAtFirst() {
        assertThat(store.missions()).isEmpty();
        assertThat(store.mission("m1")).isEmpty();
    }

    @Test
    void givesBackASavedMission() {
        SavedMission mission = mission("m1", "Roof survey", new MissionItem.TakeOff(20), new MissionItem.Land());
        store.save(mission);
        assertThat(store.mission("m1")).contains(mission);
        assertThat(store.missions()).containsExactly(mission);
    }

    @Test
    void keepsTheLongestMission() {
        MissionItem item = new MissionItem.Waypoint(new Geodetic(47.1234567 + 1e-13, 8.5), Altitude.aboveHome(30), 2.5);
        SavedMission mission = new SavedMission(
                "m1", "long", new Mission(Collections.nCopies(Mission.MAX_ITEMS, item)), "alice", CHANGED);
        store.save(mission);
        assertThat(store.mission("m1")).contains(mission);
    }

    @Test
    void replacesAMissionOfTheSameId() {
        store.save(mission("m1", "before", new MissionItem.Land()));
        SavedMission after = new SavedMission(
                "m1", "after", new Mission(List.of(new MissionItem.ReturnToLaunch())), "bob", CHANGED.plusSeconds(60));
        store.save(after);
        assertThat(store.missions()).containsExactly(after);
    }

    @Test
    void listsByNameWhateverTheCase() {
        store.save(mission("m1", "beta", new MissionItem.Land()));
        store.save(mission("m2", "Gamma", new MissionItem.Land()));
        store.save(mission("m3", "Alpha", new MissionItem.Land()));
        store.save(mission("m4", "alpha", new MissionItem.Land()));
        assertThat(store.missions()).extracting(SavedMission::name).containsExactly("Alpha", "alpha", "beta", "Gamma");
    }

    @Test
    void deletesAndSaysWhetherThereWasOne() {
        store.save(mission("m1", "one", new MissionItem.Land()));
        assertThat(store.delete("m1")).isTrue();
        assertThat(store.delete("m1")).isFalse();
        assertThat(store.missions()).isEmpty();
    }

    private static SavedMission mission(String id, String name, MissionItem... items) {
        return new SavedMission(id, name, new Mission(List.of(items)), "alice", CHANGED);
    }
}

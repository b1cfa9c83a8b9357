package org.dronemap.store.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Instant;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.link.DtlsKey;
import org.dronemap.core.link.EndpointStore;
import org.dronemap.core.link.RobotKey;
import org.dronemap.core.link.SavedEndpoint;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** What every {@link EndpointStore} keeps to. */
public abstract class EndpointStoreContract {
    private static final Instant THEN = Instant.parse("2026-03-04T05:06:07.123456Z");

    private EndpointStore store;

    /** An empty store. */
    protected abstract EndpointStore emptyStore();

    @BeforeEach
    void open() {
        store = emptyStore();
    }

    private static SavedEndpoint link(String id, String url, int second) {
        return new SavedEndpoint(id, url, "alice", THEN.plusSeconds(second));
    }

    private static DtlsKey key(String identity, String sealed, int second) {
        return new DtlsKey(identity, "Copter", sealed, "alice", THEN.plusSeconds(second));
    }

    @Test
    void givesLinksBackInTheOrderInWhichTheyWereAdded() {
        SavedEndpoint later = link("a", "udpserver://0.0.0.0:1", 2);
        SavedEndpoint earlier = link("b", "serial:///dev/ttyUSB0?baud=57600", 1);

        assertThat(store.addLink(later)).isTrue();
        assertThat(store.addLink(earlier)).isTrue();

        assertThat(store.links()).containsExactly(earlier, later);
    }

    @Test
    void takesNoUrlAndNoIdTwice() {
        SavedEndpoint first = link("a", "udpserver://0.0.0.0:1", 1);
        assertThat(store.addLink(first)).isTrue();

        assertThat(store.addLink(link("b", "udpserver://0.0.0.0:1", 2))).isFalse();
        assertThat(store.addLink(link("a", "udpserver://0.0.0.0:2", 2))).isFalse();

        assertThat(store.links()).containsExactly(first);
    }

    @Test
    void forgetsALink() {
        store.addLink(link("a", "udpserver://0.0.0.0:1", 1));

        assertThat(store.deleteLink("a")).isTrue();
        assertThat(store.deleteLink("a")).isFalse();
        assertThat(store.links()).isEmpty();
    }

    @Test
    void keepsOneKeyAnIdentityAndForgetsIt() {
        store.saveKey(key("one", "sealed 1", 1));
        store.saveKey(key("two", "sealed 2", 2));
        store.saveKey(key("one", "sealed 3", 3));

        assertThat(store.keys()).containsExactly(key("two", "sealed 2", 2), key("one", "sealed 3", 3));
        assertThat(store.deleteKey("one")).isTrue();
        assertThat(store.deleteKey("one")).isFalse();
        assertThat(store.keys()).containsExactly(key("two", "sealed 2", 2));
    }

    private static RobotKey robot(String drone, String hash, int second) {
        return new RobotKey(new DroneId(drone), "Turtle", 65_535, null, hash, "alice", "#a1", THEN.plusSeconds(second));
    }

    @Test
    void keepsTheKeyOfARobotThatHasNeverCalledIn() {
        RobotKey later = robot("drobot0001", "aa", 2);
        RobotKey earlier =
                new RobotKey(new DroneId("drobot0002"), "Burger", 0, "26", "bb", "bob", "bob", THEN.plusSeconds(1));
        store.saveRobotKey(later);
        store.saveRobotKey(earlier);

        assertThat(store.robotKeys()).containsExactly(earlier, later);
    }

    @Test
    void replacesAndForgetsTheKeyOfARobot() {
        store.saveRobotKey(robot("drobot0001", "aa", 1));
        RobotKey newer = robot("drobot0001", "cc", 3);
        store.saveRobotKey(newer);
        assertThat(store.robotKeys()).containsExactly(newer);

        assertThat(store.deleteRobotKey(newer.drone())).isTrue();
        assertThat(store.deleteRobotKey(newer.drone())).isFalse();
        assertThat(store.robotKeys()).isEmpty();
    }
}

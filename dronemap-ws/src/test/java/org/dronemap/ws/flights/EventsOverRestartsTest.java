package org.dronemap.ws.flights;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dronemap.core.access.Role;
import org.dronemap.core.history.EventEntry;
import org.dronemap.core.history.EventGap;
import org.dronemap.core.history.EventPage;
import org.dronemap.core.history.TelemetryStore;
import org.dronemap.ws.lab.LabDrone;
import org.dronemap.ws.lab.Laboratory;
import org.dronemap.ws.lab.Pilot;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** The numbered events of a server that ends, well or badly, and is started anew. */
class EventsOverRestartsTest {
    private static final int MANY = 10_000;
    private static final Duration MINUTE = Duration.ofMinutes(1);

    private final Laboratory lab = new Laboratory(1);
    private final Pilot ann = lab.pilot("ann", Role.OPERATOR);
    private final LabDrone copter = lab.copter();
    private final TelemetryStore store = lab.stores().telemetry();

    @AfterEach
    void close() {
        lab.close();
    }

    @Test
    void tellOneGapAfterAServerThatWasKilled() {
        ann.takesOff(copter, 10);
        lab.goOn(MINUTE);
        EventPage before = store.eventsAfter(0, MANY);
        List<EventEntry> events = before.entries();

        lab.crashServer();
        lab.goOn(MINUTE);
        Instant back = lab.now();
        lab.startServer();
        lab.goOn(MINUTE);

        EventPage after = store.eventsAfter(before.next(), MANY);
        assertThat(events).isNotEmpty().noneMatch(EventGap.class::isInstance);
        assertThat(after.series().id()).isEqualTo(before.series().id());
        assertThat(after.entries()).filteredOn(EventGap.class::isInstance).hasSize(1);
        assertThat(after.entries().get(0)).isInstanceOfSatisfying(EventGap.class, gap -> {
            assertThat(gap.cause()).isEqualTo(EventGap.Cause.SERVER_ENDED);
            assertThat(gap.from()).isEqualTo(events.get(events.size() - 1).at());
            assertThat(gap.until()).isEqualTo(back);
        });
    }

    @Test
    void tellNoGapAfterAServerThatEndedWell() {
        ann.takesOff(copter, 10);
        lab.goOn(MINUTE);

        lab.server().close();
        lab.crashServer();
        lab.goOn(MINUTE);
        lab.startServer();
        lab.goOn(MINUTE);

        assertThat(store.eventsAfter(0, MANY).entries()).isNotEmpty().noneMatch(EventGap.class::isInstance);
    }
}

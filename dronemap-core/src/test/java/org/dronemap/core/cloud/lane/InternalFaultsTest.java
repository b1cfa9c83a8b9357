package org.dronemap.core.cloud.lane;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.Claim;
import org.dronemap.core.cloud.CloudFixtures;
import org.dronemap.core.cloud.CloudManager;
import org.dronemap.core.cloud.CommandGate;
import org.dronemap.core.cloud.DroneLink;
import org.dronemap.core.cloud.LinkSession;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.CommandRecord;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.RelaySetting;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.time.RealTime;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

class InternalFaultsTest {
    private static final Duration PATIENCE = Duration.ofSeconds(30);
    private static final CommandGate.Source OPERATOR =
            new CommandGate.Source(new Principal("ann", Role.OPERATOR), "rest");
    private static final Outcome OUR_FAULT = new Outcome.Refused(
            "gate",
            "The cloud does not know how to do this: a fault of its own, which is logged for its makers.",
            OutcomeCode.SERVER_FAULT);

    private final Lanes lanes = new Lanes(new RealTime(), 1);
    private final StoreWriter journal = new StoreWriter(new RealTime());
    private final CloudFixtures.InMemoryCommandStore store = new CloudFixtures.InMemoryCommandStore();
    private final CloudFixtures.RecordingChannel vehicle = new CloudFixtures.RecordingChannel();
    private final CloudManager cloud = new CloudManager(
            lanes,
            Watchdog.DEFAULT,
            new RealTime(),
            new CloudManager.Persistence(
                    new CloudFixtures.InMemoryDroneStore(),
                    store,
                    new CloudFixtures.InMemoryLeaseStore(),
                    new CloudFixtures.InMemoryParameterOverrideStore(),
                    journal),
            () -> new DroneId("drone-1"));
    private final CommandGate gate = cloud.gate();
    private DroneLink link;

    @BeforeEach
    void connect() {
        LinkSession session =
                new LinkSession(new DroneKey("127.0.0.1", 14_550, 1), "udp", false, "ArduCopter 1", vehicle);
        link = CloudFixtures.bound(cloud.admit(new Claim(session, CloudFixtures.copter(null), null, true, 0)));
        link.lane().execute(() -> {
            link.accept(new DroneEvent.Identified(CloudFixtures.copter(null), CloudFixtures.ALL));
            link.accept(new DroneEvent.ModeReported("GUIDED", false));
        });
        await().until(() -> cloud.drone(link.id()).orElseThrow().mode() != null);
    }

    @AfterEach
    void close() {
        lanes.close();
        journal.close();
    }

    @Test
    void refusesAloneWhatNobodyThoughtOfHandling() {
        vehicle.forgotten = Command.TakePicture.class;
        CommandRecord other = give("other-0001", new Command.SetRelay(0, RelaySetting.ON));

        CommandRecord picture = give("photo-0001", new Command.TakePicture());

        assertThat(gate.end(picture.id())).succeedsWithin(PATIENCE);
        assertThat(store.records.get(picture.id()).outcome()).isEqualTo(OUR_FAULT);
        assertThat(vehicle.cancelled).containsExactly(picture.id());
        assertThat(store.records.get(other.id()).outcome()).isNull();
        vehicle.forgotten = null;
        assertThat(ends(give("photo-0002", new Command.TakePicture()))).isEqualTo(new Outcome.Succeeded());
        assertThat(ends(other)).isEqualTo(new Outcome.Succeeded());
    }

    private CommandRecord give(String id, Command command) {
        return gate.submit(OPERATOR, link.id(), new CommandId(id), command);
    }

    private Outcome ends(CommandRecord command) {
        await().until(() -> vehicle.reports.containsKey(command.id()));
        vehicle.reports.get(command.id()).ended(new Outcome.Succeeded());
        assertThat(gate.end(command.id())).succeedsWithin(PATIENCE);
        return store.records.get(command.id()).outcome();
    }
}

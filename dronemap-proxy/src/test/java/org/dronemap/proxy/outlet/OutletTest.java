package org.dronemap.proxy.outlet;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.time.ZoneOffset;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.time.RealTime;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Attitude;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.ControlStatus;
import org.dronemap.mavlink.message.FileTransferProtocol;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.LogEntry;
import org.dronemap.mavlink.message.LogRequestData;
import org.dronemap.mavlink.message.LogRequestList;
import org.dronemap.mavlink.message.MissionSetCurrent;
import org.dronemap.mavlink.message.ParamValue;
import org.dronemap.mavlink.message.Statustext;
import org.dronemap.mavlink.signing.OutgoingSigner;
import org.dronemap.mavlink.signing.SigningClock;
import org.dronemap.mavlink.signing.SigningKey;
import org.dronemap.proxy.TestCloud;
import org.dronemap.proxy.endpoint.DtlsKeys;
import org.dronemap.proxy.endpoint.EndpointCounters;
import org.dronemap.proxy.endpoint.EndpointSecurity;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.endpoint.PeerAddress;
import org.dronemap.proxy.endpoint.PeerCounters;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.dronemap.proxy.session.FrameTap;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Clients of the outlet in memory: who gets what. */
class OutletTest {
    private static final DroneId FIRST = new DroneId("drone-1");
    private static final DroneId SECOND = new DroneId("drone-2");
    private static final Heartbeat VEHICLE = new Heartbeat(2, 3, 81, 0, 3, 3);
    private static final Heartbeat GROUND = new Heartbeat(6, 8, 0, 0, 4, 3);
    /** Of a drone whose own number is the client's. */
    private static final int SPARE_SYSTEM_ID = 240;

    private static final Instant NOW = Instant.parse("2026-03-04T05:06:07Z");

    private final TestOutletStore store = new TestOutletStore();
    private final Map<String, Principal> users = new ConcurrentHashMap<>();
    private final TestCloud cloud = new TestCloud(0);
    private final StoreWriter journal = new StoreWriter(new RealTime());
    private Outlet outlet = open();

    private Outlet open() {
        return new Outlet(
                List.of(),
                new OutletDependencies(
                        cloud.cloud(),
                        store,
                        journal,
                        user -> Optional.ofNullable(users.get(user)),
                        (by, drone, event) -> cloud.cloud().controls().apply(drone, event),
                        new RealTime(Clock.fixed(NOW, ZoneOffset.UTC))),
                EndpointSecurity.of(DtlsKeys.none()));
    }

    @BeforeEach
    void start() throws Exception {
        users.put("ann", new Principal("ann", Role.OPERATOR));
        users.put("bob", new Principal("bob", Role.VIEWER));
        assertThat(outlet.putKey("ann", key("ann"))).isTrue();
        assertThat(outlet.putKey("bob", key("bob"))).isTrue();
        outlet.start(false);
    }

    @AfterEach
    void close() {
        outlet.close();
        journal.close();
        cloud.close();
    }

    @Test
    void showsVehiclesOfOneSystemIdUnderTwoSignedByTheClientsOwnKey() {
        Vehicle first = new Vehicle(FIRST, 1);
        Vehicle second = new Vehicle(SECOND, 1);
        Client ann = new Client("ann", 255).attach();
        first.says(VEHICLE);
        second.says(VEHICLE);
        List<Frame> heard = ann.await(2);
        assertThat(heard).extracting(Frame::systemId).containsExactly(1, 2);
        assertThat(heard).allMatch(new SigningKey(key("ann").secret())::signed);
        assertThat(heard).extracting(Frame::signatureTimestamp).doesNotHaveDuplicates();
    }

    @Test
    void talksOfTheVehicleWithTheCloudAreNotShown() {
        Vehicle vehicle = new Vehicle(FIRST, 1);
        Client ann = new Client("ann", 255).attach();
        vehicle.says(new CommandAck(400, 0, 0, 0, 255, 190));
        vehicle.says(new ParamValue("RTL_ALT", 15, 9, 1, 0));
        vehicle.says(new Statustext(6, "the last one", 0, 0));
        assertThat(ann.await(1)).extracting(Frame::messageId).containsExactly(Statustext.ID);
    }

    @Test
    void aClientWithTheNumberOfADroneKnowsThatByAnother() {
        Vehicle vehicle = new Vehicle(FIRST, 42);
        Client ann = new Client("ann", 42).attach();
        vehicle.says(VEHICLE);
        assertThat(ann.await(1)).extracting(Frame::systemId).containsExactly(SPARE_SYSTEM_ID);
    }

    @Test
    void aFrameIsGoodOnceForAllAddresses() {
        Client ann = new Client("ann", 255).attach();
        Client thief = new Client("ann", 255);
        thief.sends(ann.last());
        eventually(() -> assertThat(outlet.status().refused().replayed()).isEqualTo(1));
        assertThat(outlet.status().clients()).hasSize(1);
    }

    @Test
    void aReplayAfterARestartIsTooOldAsSoonAsTheStampIsStored() {
        Client ann = new Client("ann", 255).attach();
        ann.timeIs(NOW.plus(Duration.ofMinutes(10)));
        ann.says(GROUND);
        outlet.close();
        assertThat(store.keys())
                .filteredOn(kept -> kept.user().equals("ann"))
                .allMatch(kept -> kept.stamp() > SigningClock.timestampOf(NOW.plus(Duration.ofMinutes(10))));
        byte[] early = new Client("ann", 255).frame(GROUND);
        outlet = open();
        new Client("ann", 255).sends(early);
        eventually(() -> assertThat(outlet.status().refused().tooOld()).isEqualTo(1));
    }

    @Test
    void whatWasHeardBeforeARestartIsTakenByNobodyAfterIt() throws Exception {
        Client ann = new Client("ann", 255).attach();
        byte[] heard = ann.last();
        outlet.close();
        outlet = open();
        outlet.start(false);
        Client thief = new Client("ann", 255);
        thief.sends(heard);
        eventually(() -> assertThat(outlet.status().refused().tooOld()).isEqualTo(1));
        assertThat(thief.heard).isEmpty();
        // Her own next word is a later one.
        Client again = new Client("ann", 255);
        again.timeIs(NOW.plus(Duration.ofSeconds(1)));
        again.attach();
    }

    @Test
    void whoMayNotLookStaysOutside() {
        users.put("bob", new Principal("bob", Role.REPORTER));
        Client bob = new Client("bob", 255);
        bob.says(GROUND);
        eventually(() -> assertThat(outlet.status().refused().turnedAway()).isPositive());
        assertThat(bob.heard).isEmpty();
    }

    @Test
    void aStuckClientCostsNobodyAnythingAndLaterGetsTheNewestOfEachKind() {
        Vehicle vehicle = new Vehicle(FIRST, 1);
        Client stuck = new Client("ann", 255).attach();
        Client other = new Client("bob", 255).attach();
        stuck.stuck = true;
        for (int number = 1; number <= 2_000; number++) {
            vehicle.says(new Attitude(number, 0, 0, 0, 0, 0, 0));
        }
        vehicle.says(new Statustext(6, "an event", 0, 0));
        other.await(2_001);
        stuck.stuck = false;
        List<Frame> heard = stuck.await(3);
        assertThat(heard.stream().filter(frame -> frame.messageId() == Attitude.ID))
                .extracting(frame -> frame.u32(0))
                .containsExactly(1L, 2_000L);
        assertThat(heard.stream().filter(frame -> frame.messageId() == Statustext.ID))
                .hasSize(1);
        assertThat(stuck.ofVehicles())
                .extracting(Frame::sequence)
                .isEqualTo(IntStream.range(0, stuck.ofVehicles().size()).boxed().toList());
    }

    private static LinkKey key(String user) {
        try {
            byte[] passphrase = ("the passphrase of " + user).getBytes(StandardCharsets.US_ASCII);
            return new LinkKey(MessageDigest.getInstance("SHA-256").digest(passphrase));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }

    @Test
    void whoAsksForFilesIsToldAtOnceThatThereAreNone() {
        Vehicle vehicle = new Vehicle(FIRST, 1);
        Client bob = new Client("bob", 255).attach();
        vehicle.says(VEHICLE);
        bob.await(1);
        // Open a file to read, create one, end a session.
        bob.says(file(4, 0xFF, 4));
        bob.says(file(6, 7, 0));
        bob.says(file(1, 8, 0));
        List<int[]> answers = bob.await(4).stream()
                .filter(frame -> frame.messageId() == FileTransferProtocol.ID)
                .map(frame -> FileTransferProtocol.decode(frame).payload())
                .toList();
        assertThat(answers).extracting(payload -> payload[0] | payload[1] << 8).containsExactly(0x100, 8, 9);
        assertThat(answers).extracting(payload -> payload[3]).containsExactly(129, 129, 128);
        assertThat(answers).extracting(payload -> payload[5]).containsExactly(4, 6, 1);
        assertThat(answers).extracting(payload -> payload[12]).containsExactly(10, 9, 0);
    }

    @Test
    void whoAsksForLogsOrForAnotherItemIsToldWhereInstead() {
        Vehicle vehicle = new Vehicle(FIRST, 1);
        Client bob = new Client("bob", 255).attach();
        vehicle.says(VEHICLE);
        bob.await(1);
        bob.says(new LogRequestList(1, 1, 0, 0xFFFF));
        bob.says(new LogRequestData(1, 1, 1, 0, 90));
        bob.says(new LogRequestData(1, 1, 1, 90, 90));
        bob.says(new MissionSetCurrent(1, 1, 2));
        eventually(() -> assertThat(texts(bob)).contains("upload the mission from there on."));
        assertThat(texts(bob).split("are fetched from the server's page", -1)).hasSize(3);
        List<LogEntry> entries = bob.ofVehicles().stream()
                .filter(frame -> frame.messageId() == LogEntry.ID)
                .map(LogEntry::decode)
                .toList();
        assertThat(entries).extracting(LogEntry::numLogs).containsExactly(0);
    }

    private static String texts(Client client) {
        return client.ofVehicles().stream()
                .filter(frame -> frame.messageId() == Statustext.ID)
                .map(frame -> Statustext.decode(frame).text())
                .collect(Collectors.joining());
    }

    private static FileTransferProtocol file(int opcode, int number, int session) {
        int[] payload = new int[251];
        payload[0] = number;
        payload[2] = session;
        payload[3] = opcode;
        return new FileTransferProtocol(0, 1, 1, payload);
    }

    private static void eventually(Runnable check) {
        long deadline = System.nanoTime() + 10_000_000_000L;
        while (true) {
            try {
                check.run();
                return;
            } catch (AssertionError e) {
                if (System.nanoTime() > deadline) {
                    throw e;
                }
                Thread.onSpinWait();
            }
        }
    }

    /** One that speaks through its tap. */
    private final class Vehicle {
        private final FrameTap tap = outlet.open(1);
        private final FrameWriter writer;

        Vehicle(DroneId drone, int systemId) {
            writer = new FrameWriter(systemId, 1, 2);
            tap.bound(drone);
        }

        void says(Message message) {
            tap.admitted(read(writer.frame(message)));
        }
    }

    private static Frame read(byte[] raw) {
        List<Frame> frames = new CopyOnWriteArrayList<>();
        new FrameReader().read(ByteBuffer.wrap(raw), frames::add);
        return frames.get(0);
    }

    /** One whose link is in memory. */
    private final class Client implements Peer {
        private final List<Frame> heard = new CopyOnWriteArrayList<>();
        private final PeerHandler handler = outlet.opened(this, new PeerCounters(new EndpointCounters()));
        private final FrameWriter writer;
        private final String user;
        private OutgoingSigner signer;
        private byte[] last = {};
        private volatile boolean stuck;

        Client(String user, int systemId) {
            this.user = user;
            writer = new FrameWriter(systemId, 190, 2);
            signer = signer(NOW);
        }

        private OutgoingSigner signer(Instant now) {
            return new OutgoingSigner(
                    new SigningKey(key(user).secret()), new SigningClock(Clock.fixed(now, ZoneOffset.UTC), 0), 0);
        }

        void timeIs(Instant now) {
            signer = signer(now);
        }

        byte[] frame(Message message) {
            return writer.frame(message, signer);
        }

        byte[] last() {
            return last.clone();
        }

        void says(Message message) {
            sends(frame(message));
        }

        void sends(byte[] raw) {
            last = raw;
            handler.received(ByteBuffer.wrap(raw));
        }

        /** Returns when it is there; what the cloud said for itself meanwhile is forgotten. */
        Client attach() {
            int before = outlet.status().clients().size();
            says(GROUND);
            eventually(() -> assertThat(outlet.status().clients()).hasSize(before + 1));
            heard.clear();
            return this;
        }

        /** What vehicles said, once it is that much. */
        List<Frame> await(int count) {
            eventually(() -> assertThat(told()).hasSizeGreaterThanOrEqualTo(count));
            return told();
        }

        /** Without who has control of them, which the cloud says in their names. */
        private List<Frame> told() {
            return ofVehicles().stream()
                    .filter(frame -> frame.messageId() != ControlStatus.ID)
                    .toList();
        }

        List<Frame> ofVehicles() {
            return heard.stream().filter(frame -> frame.systemId() < 250).toList();
        }

        @Override
        public PeerAddress address() {
            return new PeerAddress("192.0.2.1", 5_000);
        }

        @Override
        public String transport() {
            return "tcp";
        }

        @Override
        public boolean offer(byte[] frame) {
            if (stuck) {
                return false;
            }
            heard.add(read(frame));
            return true;
        }

        @Override
        public void send(byte[] frame) {
            throw new IllegalStateException("the outlet offers");
        }
    }
}

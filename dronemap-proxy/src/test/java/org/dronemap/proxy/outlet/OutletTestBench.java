package org.dronemap.proxy.outlet;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import java.util.stream.Collectors;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.cloud.lane.StoreWriter;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.lease.LeaseEvent;
import org.dronemap.core.time.SteppedTime;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.Statustext;
import org.dronemap.proxy.TestCloud;
import org.dronemap.proxy.endpoint.DtlsKeys;
import org.dronemap.proxy.endpoint.EndpointSecurity;
import org.dronemap.proxy.session.FrameTap;

/** A cloud with one vehicle, and ground stations at its outlet, all in stepped time. */
final class OutletTestBench implements AutoCloseable {
    static final Heartbeat GROUND = new Heartbeat(6, 8, 0, 0, 4, 3);
    private static final Duration PATIENCE = Duration.ofSeconds(20);
    private static final Map<String, Principal> USERS = Map.of(
            "ann", new Principal("ann", Role.OPERATOR),
            "bob", new Principal("bob", Role.OPERATOR),
            "eve", new Principal("eve", Role.VIEWER));

    private final SteppedTime time = new SteppedTime(Instant.parse("2026-03-04T05:06:07Z"));
    private final StoreWriter journal = new StoreWriter(time);
    private final Taps taps = new Taps();
    private final TestCloud cloud = new TestCloud(taps, time);
    private final Outlet outlet = new Outlet(
            List.of(),
            new OutletDependencies(
                    cloud.cloud(),
                    new TestOutletStore(),
                    journal,
                    user -> Optional.ofNullable(USERS.get(user)),
                    (by, drone, event) -> cloud.cloud().controls().apply(drone, event),
                    time),
            EndpointSecurity.of(DtlsKeys.none()));
    private final MatrixVehicle vehicle;
    private final DroneId drone;

    OutletTestBench() throws IOException {
        this(1);
    }

    /** With a vehicle of so many parameters. */
    OutletTestBench(int parameters) throws IOException {
        taps.outlet = outlet;
        USERS.keySet().forEach(user -> outlet.putKey(user, MatrixClient.key(user)));
        outlet.start(false);
        vehicle = new MatrixVehicle(cloud.proxy().handlers(), time, parameters);
        drone = cloud.awaitDrone(state -> state.capabilities().known()).id();
    }

    /** Who has control of the drone. */
    ControlState control() {
        return cloud.cloud().controls().control(drone);
    }

    Outlet outlet() {
        return outlet;
    }

    void control(LeaseEvent event) {
        cloud.cloud().controls().apply(drone, event);
    }

    /** How the vehicle is from now on, as the cloud sees it. */
    void is(MatrixVehicle.State state) {
        vehicle.is(state);
        await(() -> cloud.awaitDrone(now -> true).airborne() == state.flies(), "the cloud does not see it");
    }

    /** All that came in at the vehicle. */
    List<Frame> reachedVehicle(int message) {
        return vehicle.heard().stream()
                .filter(frame -> frame.messageId() == message)
                .toList();
    }

    @Override
    public void close() throws IOException {
        outlet.close();
        vehicle.close();
        cloud.close();
        journal.close();
    }

    /** One that keeps what it hears. */
    final class Station {
        private final List<Frame> heard = new CopyOnWriteArrayList<>();
        private final MatrixClient client;

        Station(String user, int systemId) {
            this(user, systemId, (station, frame) -> {});
        }

        /** Returns when it hears the vehicle; {@code answering} hears all that it is sent. */
        Station(String user, int systemId, BiConsumer<Station, Frame> answering) {
            client = new MatrixClient(
                    outlet,
                    user,
                    systemId,
                    frame -> {
                        heard.add(frame);
                        answering.accept(this, frame);
                    },
                    time.clock());
            client.says(GROUND);
            await(client::seesAVehicle, user + " hears no vehicle");
        }

        void says(Message message) {
            client.says(message);
        }

        /** Its link takes nothing while it is. */
        void isStuck(boolean now) {
            client.isStuck(now);
        }

        List<Frame> of(int message) {
            return heard.stream().filter(frame -> frame.messageId() == message).toList();
        }

        /** The next of its kind that comes after something is said. */
        Frame answer(int message, Message question) {
            int before = of(message).size();
            says(question);
            await(() -> of(message).size() > before, "it is not answered");
            return of(message).get(before);
        }

        void awaitText(String sentence) {
            await(() -> texts().contains(sentence), sentence + " is not said");
        }

        String texts() {
            return of(Statustext.ID).stream()
                    .map(frame -> Statustext.decode(frame).text())
                    .collect(Collectors.joining());
        }
    }

    void await(BooleanSupplier wanted, String otherwise) {
        if (!time.advanceUntil(wanted, PATIENCE)) {
            throw new AssertionError(otherwise);
        }
    }

    void letPass(Duration some) {
        time.advance(some);
    }

    /** The outlet is built of the cloud that it taps. */
    private static final class Taps implements FrameTap.Factory {
        private volatile Outlet outlet;

        @Override
        public FrameTap open(int componentId) {
            return outlet.open(componentId);
        }
    }
}

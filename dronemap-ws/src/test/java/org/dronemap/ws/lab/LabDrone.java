package org.dronemap.ws.lab;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.proxy.endpoint.PeerHandler;
import org.dronemap.sim.autopilot.SimulatedVehicle;
import org.dronemap.sim.flight.NavigationEstimator;
import org.dronemap.sim.flight.SimulatedCraft;
import org.dronemap.sim.physics.BatteryModel;
import org.dronemap.sim.physics.LocalFrame;
import org.dronemap.sim.physics.NeuPosition;
import org.dronemap.sim.physics.SensorNoise;
import org.dronemap.sim.physics.WindModel;
import org.jspecify.annotations.Nullable;

/** One vehicle of the laboratory: what it truly does, its wire, and the drone that the server takes it for. */
public final class LabDrone implements LabVehicle {
    /** Where the first one stands; altitude in m AMSL. */
    public static final LocalFrame FIELD = new LocalFrame(47.3977, 8.5456, 488);

    private static final double MILLIAMP_HOURS = 5_200;
    private static final int FIRST_PORT = 20_000;
    private static final int PORTS_APART = 250;
    private static final long SEED_OF_ANOTHER_WIRE = 7_919;
    private static final double MILLIS = 1_000;
    private static final long FIX_NANOS = 100_000_000;

    private final Laboratory lab;
    private final String name;
    private final int systemId;
    /** It says only when it is not ready. */
    private final boolean isPx4;

    private final List<LabVehicleLink> wires = new ArrayList<>();
    private final SimulatedVehicle vehicle;
    private final LocalFrame start;
    private final long seed;
    private final FlightFingerprint record;
    private final VehicleTrack track = new VehicleTrack();

    /** Which one it is, what it calls itself, and what comes by chance to it. */
    record Numbers(int number, int systemId, long seed) {}

    LabDrone(Laboratory lab, VehicleSpec kit, LocalFrame start, Numbers numbers, FlightFingerprint record) {
        this.lab = lab;
        this.systemId = numbers.systemId();
        this.isPx4 = kit.kind().name().equals("px4");
        this.name = kit.kind().name() + " " + numbers.number();
        this.start = start;
        this.seed = numbers.seed();
        this.record = record;
        wires.add(newWire(name, FIRST_PORT + numbers.number()));
        SimulatedCraft craft = new SimulatedCraft(
                start,
                kit.kind().body().get(),
                new BatteryModel(MILLIAMP_HOURS),
                new WindModel(kit.windSpeed(), 0, seed),
                new NavigationEstimator((long) (kit.readySeconds() * MILLIS)),
                kit.noisy() ? SensorNoise.of(seed) : SensorNoise.none());
        this.vehicle = new SimulatedVehicle(
                kit.settings(systemId, numbers.number(), lab.now().toEpochMilli() * 1_000),
                kit.kind(),
                craft,
                this::say);
    }

    private LabVehicleLink newWire(String label, int port) {
        return new LabVehicleLink(
                label,
                port,
                lab.time(),
                seed + wires.size() * SEED_OF_ANOTHER_WIRE,
                record,
                frame -> this.vehicle().receive(frame));
    }

    /** It speaks over one more from now on, always the same on all, and hears on each. */
    public LabVehicleLink addWire(LabVehicleLink.Kind kind) {
        int number = wires.size();
        LabVehicleLink added = newWire(name + " by wire " + number, FIRST_PORT + number * PORTS_APART + systemId);
        added.is(kind);
        wires.add(added);
        added.attach(lab.server().links());
        return added;
    }

    private void say(byte[] bytes) {
        wires.forEach(wire -> wire.up(bytes));
    }

    void attach(PeerHandler.@Nullable Factory server) {
        wires.forEach(wire -> wire.attach(server));
    }

    void beat() {
        vehicle.advance(lab.time().nanos() / Duration.ofMillis(1).toNanos());
        if (vehicle.changeAddress()) {
            wires.forEach(LabVehicleLink::move);
        }
        if (lab.time().nanos() % FIX_NANOS == 0) {
            track.add(new VehicleTrack.Fix(lab.time().nanos(), where(), amsl(), height(), craft().armed()));
        }
    }

    int systemId() {
        return systemId;
    }

    public String name() {
        return name;
    }

    /** The first one, or the only one. */
    @Override
    public LabVehicleLink wire() {
        return wires.get(0);
    }

    /** What it truly is and does. */
    public SimulatedVehicle vehicle() {
        return vehicle;
    }

    public SimulatedCraft craft() {
        return vehicle.craft();
    }

    /** Metres above where it took off, in truth. */
    public double height() {
        return craft().aboveHome();
    }

    /** Metres from there on the ground, in truth. */
    public double away() {
        return craft().body().position().horizontalDistanceTo(new NeuPosition(0, 0, 0));
    }

    /** Where it is, in truth. */
    public Geodetic where() {
        NeuPosition here = craft().truePosition();
        return new Geodetic(start.latitudeOf(here), start.longitudeOf(here));
    }

    /** Metres above the sea, in truth. */
    public double amsl() {
        return start.altitudeOf(craft().truePosition());
    }

    /** Metres above the sea where it was put down. */
    public double groundAmsl() {
        return start.altitudeAmsl();
    }

    /** The number of the mode that it is in, in truth. */
    public long mode() {
        return vehicle.autopilot().heartbeat().customMode();
    }

    /** Its pilot, who stands beside it, brings it into that mode by a switch. */
    public void switchedTo(long mode) {
        var unused = vehicle.autopilot().setMode(1, mode);
    }

    /** Where it truly was all along. */
    public VehicleTrack track() {
        return track;
    }

    /** What the server has heard it say in words. */
    public boolean isTold(String words) {
        return state().messages().stream().anyMatch(message -> message.text().contains(words));
    }

    /** All is known of it that a plan takes. */
    boolean isPlannable() {
        return isReady()
                && known().filter(state -> state.battery() != null
                                && state.link().quality().lossShort() != null)
                        .isPresent();
    }

    /** It is down and its motors stand, in truth. */
    public boolean isDown() {
        return !craft().armed() && craft().landed();
    }

    /** That many metres north and east of where it was put down. */
    public Geodetic place(double north, double east) {
        NeuPosition offset = new NeuPosition(north, east, 0);
        return new Geodetic(start.latitudeOf(offset), start.longitudeOf(offset));
    }

    /** Metres between it and a place on the ground, in truth. */
    public double distanceTo(Geodetic place) {
        return craft().body()
                .position()
                .horizontalDistanceTo(start.locate(place.latitudeDegrees(), place.longitudeDegrees(), 0));
    }

    @Override
    public Optional<DroneState> known() {
        List<DroneState> named = lab.server().house().cloud().drones().stream()
                .filter(state -> state.link().key().systemId() == systemId)
                .toList();
        Optional<DroneState> own = named.stream()
                .filter(state -> wires.stream()
                        .anyMatch(wire -> wire.port() == state.link().key().port()))
                .findFirst();
        return own.isPresent() || lab.hasTwins(systemId) ? own : named.stream().findFirst();
    }

    public boolean isLost() {
        return state().link().state() == LinkState.LOST;
    }

    boolean isReady() {
        return known().filter(state -> state.link().state() == LinkState.LIVE
                        && state.position() != null
                        && state.home() != null
                        && state.capabilities().known()
                        && (isPx4
                                ? !Boolean.FALSE.equals(state.readyToArm())
                                : Boolean.TRUE.equals(state.readyToArm())))
                .isPresent();
    }

    @Override
    public String words() {
        return name + ": truly " + (craft().armed() ? "armed" : "disarmed")
                + String.format(", %.1f m up, %.1f m away; ", height(), away())
                + "for the server "
                + known().map(state -> state.mode() + ", armed " + state.armed() + ", "
                                + state.link().state() + ", " + state.messages())
                        .orElse("unknown");
    }
}

package org.dronemap.proxy.outlet.client;

import java.time.Instant;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Set;
import java.util.regex.Pattern;
import org.dronemap.core.access.Principal;
import org.dronemap.core.access.Role;
import org.dronemap.core.drone.DroneId;
import org.dronemap.mavlink.FrameSigner;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.proxy.endpoint.Peer;
import org.dronemap.proxy.outlet.rights.OutletCredential;
import org.dronemap.proxy.outlet.rights.RightsHolder;
import org.jspecify.annotations.Nullable;

/**
 * One ground station or program attached to the outlet: its user's rights and its send queue. Owned by the outlet's
 * thread; only {@link #setRights} comes from another one.
 */
public final class OutletClient implements RightsHolder {
    /** MAV_COMP_ID_MISSIONPLANNER: what speaks for a ground station. */
    private static final int OWN_COMPONENT = 190;

    private static final int OWN_SYSTEM = 255;
    private static final int MOST_ORDERS = 50;
    private static final int MOST_SETPOINTS = 500;
    private static final int OTHER_SYSTEM = 254;
    private static final Heartbeat HEARTBEAT = new Heartbeat(6, 8, 0, 0, 4, 3);

    private final String id;
    private final Peer peer;
    private final OutletCredential pass;
    private final OutletSystemIdRegistry numbers;
    private final Instant since;
    private final int systemId;
    private final ClientSendQueue outbox = new ClientSendQueue();
    private final Map<Integer, FrameWriter> writers = new HashMap<>();
    private final PerSecondCounter in = new PerSecondCounter();
    private final PerSecondCounter out = new PerSecondCounter();
    private final Set<DroneId> shown = new HashSet<>();
    private byte @Nullable [] ready;
    private int orders;
    private int setpoints;
    private int lastText;
    /** When it was told what; of a few sentences. */
    private static final Pattern NUMBERS = Pattern.compile("[-0-9.]+");

    private final Map<String, Long> explainedNanos = new HashMap<>();

    private long lastReceivedNanos;
    private volatile @Nullable Principal principal;

    /** The identity of a client: its credential, its own system id, and since when it is attached. */
    public record Entry(String id, OutletCredential pass, int systemId, Instant since, long nowNanos) {}

    public OutletClient(Entry entry, Peer peer, OutletSystemIdRegistry numbers, Principal principal) {
        this.id = entry.id();
        this.pass = entry.pass();
        this.systemId = entry.systemId();
        this.since = entry.since();
        this.lastReceivedNanos = entry.nowNanos();
        this.peer = peer;
        this.numbers = numbers;
        this.principal = pass.rights(principal);
    }

    public String id() {
        return id;
    }

    public OutletCredential pass() {
        return pass;
    }

    /** True when it came in by something by which nothing is ever changed. */
    public boolean onlyLooks() {
        return pass.onlyLooks();
    }

    @Override
    public String user() {
        return pass.user();
    }

    public Peer peer() {
        return peer;
    }

    /** What it calls itself. */
    public int systemId() {
        return systemId;
    }

    /** What the cloud calls itself to it. */
    public int cloudId() {
        return systemId == OWN_SYSTEM ? OTHER_SYSTEM : OWN_SYSTEM;
    }

    /** True when nothing waits for it. */
    public boolean isUpToDate() {
        return outbox.isEmpty();
    }

    /** True when answers and events find room while its link takes nothing. */
    public boolean hasRoom() {
        return outbox.hasRoom();
    }

    /** What its user may do from now on; null: nothing any more. Any thread. */
    @Override
    public void setRights(@Nullable Principal now) {
        principal = now == null ? null : pass.rights(now);
    }

    /** Null when its user may do nothing any more. */
    @Nullable
    public Principal principal() {
        return principal;
    }

    public boolean sees(DroneId drone) {
        Principal now = principal;
        return now != null && now.may(Role.VIEWER, drone);
    }

    /** It sees the drone, and has heard it. */
    public boolean shows(DroneId drone) {
        return shown.contains(drone) && sees(drone);
    }

    public void received(long nowNanos) {
        lastReceivedNanos = nowNanos;
        in.count();
    }

    public long silenceNanos(long nowNanos) {
        return nowNanos - lastReceivedNanos;
    }

    /** Shows what a vehicle said; what finds no room waits as the newest of its kind, or as an event in order. */
    public void forward(ClientMessage.OfVehicle letter, boolean isEvent) {
        if (!sees(letter.drone())) {
            return;
        }
        if (outbox.isEmpty() && ready == null) {
            send(letter);
        } else if (isEvent) {
            outbox.add(letter);
        } else {
            outbox.addNewest(letter);
        }
    }

    /** Says something of the cloud's own, after what waits already. */
    public void enqueue(ClientMessage letter) {
        outbox.add(letter);
        flush();
    }

    /** Sends what waits until the link takes no more. */
    public void flush() {
        if (ready != null && !offer(ready)) {
            return;
        }
        ready = null;
        outbox.drain(this::send);
    }

    /** A sign of life of the cloud itself, for whoever sees no vehicle. */
    public void sendHeartbeat() {
        enqueue(new ClientMessage.OfCloud(HEARTBEAT));
    }

    /** False when the link took no more before: nothing was begun. */
    private boolean send(ClientMessage letter) {
        if (ready != null) {
            return false;
        }
        byte[] frame = frame(letter);
        if (frame != null && !offer(frame)) {
            // It has its number and its signature already: it goes first.
            ready = frame;
        }
        return true;
    }

    private boolean offer(byte[] frame) {
        boolean taken = peer.offer(frame);
        if (taken) {
            out.count();
        }
        return taken;
    }

    /** Null when it must not, or cannot, be shown any more. */
    private byte @Nullable [] frame(ClientMessage letter) {
        if (letter instanceof ClientMessage.OfVehicle vehicle) {
            return copy(vehicle);
        }
        if (letter instanceof ClientMessage.ForVehicle spoken) {
            int number = numberOf(spoken.drone(), 0);
            return number == 0 ? null : frame(writer(number, spoken.component()), spoken.message());
        }
        Message message = ((ClientMessage.OfCloud) letter).message();
        return frame(writer(cloudId(), OWN_COMPONENT), message);
    }

    private byte[] frame(FrameWriter writer, Message message) {
        FrameSigner signer = pass.signer();
        return signer == null ? writer.frame(message) : writer.frame(message, signer);
    }

    private byte @Nullable [] copy(ClientMessage.OfVehicle letter) {
        int number = numberOf(letter.drone(), letter.frame().systemId());
        return number == 0
                ? null
                : writer(number, letter.frame().componentId())
                        .copy(letter.frame(), pass.signer())
                        .orElse(null);
    }

    /** Under which system id this program knows a drone; 0: under none. */
    private int numberOf(DroneId drone, int vehiclesOwn) {
        if (!sees(drone)) {
            shown.remove(drone);
            return 0;
        }
        OptionalInt number = numbers.of(user(), drone, vehiclesOwn);
        if (number.isEmpty()) {
            return 0;
        }
        shown.add(drone);
        return number.getAsInt() == systemId ? OutletSystemIdRegistry.SPARE : number.getAsInt();
    }

    /** The drone that this program calls so, if its user may see it. */
    @Nullable
    public DroneId drone(int number) {
        int kept = number == OutletSystemIdRegistry.SPARE ? systemId : number;
        boolean itself = number == systemId;
        DroneId drone = itself ? null : numbers.drone(user(), kept);
        return drone != null && sees(drone) ? drone : null;
    }

    private FrameWriter writer(int number, int component) {
        return writers.computeIfAbsent(number << 8 | component, key -> new FrameWriter(number, component, 2));
    }

    /** False when it has given more commands within this second than anybody does by hand or by a sane program. */
    public boolean mayOrder() {
        return ++orders <= MOST_ORDERS;
    }

    /** False when it has said more setpoints within this second than ten joysticks do; others come soon. */
    public boolean maySteer() {
        return ++setpoints <= MOST_SETPOINTS;
    }

    /** Numbers texts that come in parts, 1 to 65535. */
    public int nextText() {
        lastText = lastText % 65_535 + 1;
        return lastText;
    }

    /** True at most once in so long for each sentence. */
    public boolean mayExplain(String sentence, long nowNanos, long everyNanos) {
        // The same with other numbers is the same.
        String kind = NUMBERS.matcher(sentence).replaceAll("#");
        Long before = explainedNanos.get(kind);
        boolean due = before == null || nowNanos - before > everyNanos;
        if (due) {
            explainedNanos.values().removeIf(then -> nowNanos - then > everyNanos);
            explainedNanos.put(kind, nowNanos);
        }
        return due;
    }

    /** Ends a second of counting. */
    public void second() {
        orders = 0;
        setpoints = 0;
        in.second();
        out.second();
        shown.removeIf(drone -> !sees(drone));
    }

    public OutletStatus.Client status(long nowNanos) {
        return new OutletStatus.Client(
                id,
                user(),
                peer.address().toString(),
                peer.transport(),
                systemId,
                shown.size(),
                since,
                in.total(),
                out.total(),
                in.perSecond(),
                out.perSecond(),
                outbox.dropped(),
                outbox.waiting() + (ready == null ? 0 : 1),
                silenceNanos(nowNanos) / 1e9);
    }
}

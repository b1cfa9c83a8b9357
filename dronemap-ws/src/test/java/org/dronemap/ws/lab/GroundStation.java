package org.dronemap.ws.lab;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.dronemap.core.time.ScheduledTask;
import org.dronemap.core.time.Worker;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameReader;
import org.dronemap.mavlink.FrameWriter;
import org.dronemap.mavlink.Message;
import org.dronemap.mavlink.message.CommandAck;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.Statustext;
import org.dronemap.mavlink.signing.OutgoingSigner;
import org.dronemap.mavlink.signing.SigningClock;
import org.dronemap.mavlink.signing.SigningKey;
import org.dronemap.ws.wiring.SteppedServer;
import org.jspecify.annotations.Nullable;

/**
 * A ground station of another maker: says that it is there twice a second, keeps what it hears, and signs by a passphrase or
 * not at all. Its signatures are made as programs in the field make them: by the time of its start, then one more for each
 * frame, and never earlier than what it has heard.
 */
public final class GroundStation {
    public static final Heartbeat BEAT = new Heartbeat(6, 8, 0, 0, 4, 3);

    private static final int GROUND_STATION = 6;
    private static final int COMPONENT = 190;
    private static final Duration BETWEEN_BEATS = Duration.ofMillis(500);
    /** On a line where frames overtake one another, most heartbeats come later than what was signed after them. */
    private static final Duration LONGEST = Duration.ofSeconds(60);

    private static final Duration LONGEST_ANSWER = Duration.ofSeconds(30);
    private static final Duration OFTEN = Duration.ofMillis(100);

    private final Laboratory lab;
    private final String name;
    private final LabPeerLink line;
    private final FrameWriter writer;
    private final Worker hands;
    private final FrameReader reader = new FrameReader();
    private final List<Heard> heard = new ArrayList<>();
    private final Map<Integer, List<Frame>> kinds = new HashMap<>();
    private final Map<Integer, Long> lastStamps = new HashMap<>();
    private final int linkId;
    private @Nullable SigningKey key;
    private @Nullable OutgoingSigner signer;
    private Instant latest;
    private boolean silent;
    private int notItsOwn;

    /** A frame and when it came. */
    public record Heard(Frame frame, Instant at) {}

    GroundStation(Laboratory lab, int number, LabPeerLink.Kind kind, @Nullable String passphrase, int systemId) {
        this.lab = lab;
        this.name = "station " + number;
        this.linkId = number;
        this.latest = lab.now();
        line = new LabPeerLink(lab, 40_000 + number, kind, SteppedServer::stations, this::hear);
        writer = new FrameWriter(systemId, COMPONENT, 2);
        signsWith(passphrase);
        hands = lab.time().worker(name, 100);
        var unused = hands.every(Duration.ZERO, BETWEEN_BEATS, this::beat);
    }

    /** As all ground stations make it of a passphrase. */
    static byte[] secret(String passphrase) {
        try {
            return MessageDigest.getInstance("SHA-256").digest(passphrase.getBytes(StandardCharsets.US_ASCII));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException(e);
        }
    }

    /** From now on; null: it signs nothing. */
    public void signsWith(@Nullable String passphrase) {
        key = passphrase == null ? null : new SigningKey(secret(passphrase));
        signer = key == null ? null : signer(key);
    }

    private OutgoingSigner signer(SigningKey with) {
        return new OutgoingSigner(with, new SigningClock(() -> latest, 0), linkId);
    }

    private void beat() {
        if (!silent) {
            says(BEAT);
        }
    }

    /** It says nothing by itself any more. */
    public void fallsSilent() {
        silent = true;
    }

    public LabPeerLink line() {
        return line;
    }

    /** A message as it would say it now, with its number and its signature. */
    public byte[] frame(Message message) {
        OutgoingSigner with = signer;
        return with == null ? writer.frame(message) : writer.frame(message, with);
    }

    /** A message as it would have signed it at that time. */
    public byte[] frame(Message message, Instant then) {
        Instant now = latest;
        latest = then;
        try {
            OutgoingSigner old = signer(Optional.ofNullable(key).orElseThrow());
            return writer.frame(message, old);
        } finally {
            latest = now;
        }
    }

    public GroundStation says(Message message) {
        return sends(frame(message));
    }

    public GroundStation sends(byte[] bytes) {
        line.up(bytes);
        return this;
    }

    /** Says the same ten times a second until that is called off, as programs that steer do. */
    public ScheduledTask saysOn(Message message) {
        return hands.every(Duration.ZERO, OFTEN, () -> says(message));
    }

    private void hear(byte[] bytes) {
        reader.read(ByteBuffer.wrap(bytes), this::hear);
    }

    private void hear(Frame frame) {
        SigningKey own = key;
        if (own == null) {
            keep(frame);
        } else if (isGood(own, frame)) {
            latest = time(Math.max(stamp(latest), frame.signatureTimestamp()));
            keep(frame);
        } else {
            notItsOwn++;
        }
    }

    private void keep(Frame frame) {
        heard.add(new Heard(frame, lab.now()));
        kinds.computeIfAbsent(frame.messageId(), first -> new ArrayList<>()).add(frame);
    }

    /** As ground stations judge: rightly signed, and later than all before in its stream. */
    private boolean isGood(SigningKey own, Frame frame) {
        if (!frame.verified() || !frame.signed() || !own.signed(frame)) {
            return false;
        }
        int stream = frame.systemId() << 16 | frame.componentId() << 8 | frame.signatureLinkId();
        Long before = lastStamps.put(stream, frame.signatureTimestamp());
        return before == null || frame.signatureTimestamp() > before;
    }

    private static long stamp(Instant moment) {
        return SigningClock.timestampOf(moment);
    }

    private static Instant time(long stamp) {
        long ticks = SigningClock.TICKS_PER_SECOND;
        return Instant.parse("2015-01-01T00:00:00Z").plusSeconds(stamp / ticks).plusNanos(stamp % ticks * 10_000);
    }

    /** Frames that it threw away, as they were not signed as they must be. */
    public int notItsOwn() {
        return notItsOwn;
    }

    public List<Heard> all() {
        return List.copyOf(heard);
    }

    /** All of that kind in the name of that system; of any system: 0. */
    public List<Frame> heard(int message, int system) {
        return kinds.getOrDefault(message, List.of()).stream()
                .filter(frame -> system == 0 || frame.systemId() == system)
                .toList();
    }

    public <M> List<M> heard(int message, int system, Function<Frame, M> decode) {
        return heard(message, system).stream().map(decode).toList();
    }

    /** When it last heard of that system. */
    public Instant lastHeard(int system) {
        return heard.stream()
                .filter(one -> one.frame().systemId() == system)
                .map(Heard::at)
                .reduce((before, after) -> after)
                .orElse(Instant.MIN);
    }

    /** The system ids of all whose autopilot it heard. */
    public Set<Integer> vehicles() {
        return heard(Heartbeat.ID, 0).stream()
                .filter(frame -> Heartbeat.decode(frame).type() != GROUND_STATION)
                .map(Frame::systemId)
                .collect(Collectors.toCollection(TreeSet::new));
    }

    /** Waits until it hears so many. */
    public List<Integer> hears(int count) {
        lab.until(
                name + " hears " + count + " vehicles",
                LONGEST,
                () -> vehicles().size() >= count);
        assertThat(vehicles()).hasSize(count);
        return List.copyOf(vehicles());
    }

    /** Messages that are missing from the numbers of that system's autopilot. */
    public int gaps(int system) {
        int missing = 0;
        int next = -1;
        for (Heard one : heard) {
            if (one.frame().systemId() == system && one.frame().componentId() == 1) {
                missing += next < 0 ? 0 : (one.frame().sequence() - next) & 0xFF;
                next = (one.frame().sequence() + 1) & 0xFF;
            }
        }
        return missing;
    }

    /** Sends that system a command; the result that it is acknowledged with. */
    public int command(int system, int command, double... params) {
        int before = heard(CommandAck.ID, system).size();
        float[] seven = new float[7];
        for (int i = 0; i < params.length; i++) {
            seven[i] = (float) params[i];
        }
        says(new CommandLong(
                system, 1, command, 0, seven[0], seven[1], seven[2], seven[3], seven[4], seven[5], seven[6]));
        return lab.until(
                "command " + command + " is acknowledged",
                LONGEST_ANSWER,
                () -> heard(CommandAck.ID, system, CommandAck::decode).stream()
                        .skip(before)
                        .filter(ack -> ack.command() == command)
                        .map(CommandAck::result)
                        .findFirst());
    }

    /** What it was told in words, without breaks between what came in parts. */
    public String texts() {
        return heard(Statustext.ID, 0, Statustext::decode).stream()
                .map(Statustext::text)
                .collect(Collectors.joining());
    }
}

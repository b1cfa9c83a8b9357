package org.dronemap.proxy.signing;

import java.time.InstantSource;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.function.BiConsumer;
import java.util.function.Consumer;
import org.dronemap.core.access.LinkKey;
import org.dronemap.core.access.LinkSecurity;
import org.dronemap.core.access.LinkSigningPolicy;
import org.dronemap.core.drone.DroneId;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.FrameSigner;
import org.dronemap.mavlink.message.RadioStatus;
import org.dronemap.mavlink.signing.SignatureVerdict;
import org.dronemap.mavlink.signing.SigningClock;
import org.jspecify.annotations.Nullable;

/**
 * The MAVLink signing keys of one drone: verifies its frames on any link, signs frames to it, and changes keys.
 * Thread-safe: every method holds the object's lock, and none of them waits for anything.
 */
final class Keyring {
    private static final long GRACE_NANOS = 30_000_000_000L;
    private static final long STAMP_NANOS = 50_000_000_000L;
    private static final long MINUTE = 60 * SigningClock.TICKS_PER_SECOND;
    private static final int RADIO = 166;

    private final DroneId drone;
    private final Callbacks keeper;
    private final SigningClock clock;
    private final SignatureRefusals refusals = new SignatureRefusals();
    private final Set<LinkGuard> links;
    private int systemId;
    private LinkSigningPolicy policy;
    private @Nullable ActiveKey current;
    private @Nullable ActiveKey next;
    private @Nullable ActiveKey previous;
    private long previousUntilNanos;
    private boolean proven;
    private @Nullable KeyChange change;
    private boolean changeConfirmed;
    private CompletableFuture<KeyChangeResult> changeEnd = new CompletableFuture<>();
    private long stampedNanos;

    /**
     * The callbacks of a keyring, none of which may wait. {@code keep} runs its second argument when that is durable.
     */
    record Callbacks(BiConsumer<LinkSecurity, Runnable> keep, Consumer<LinkSecurity> stamp, Consumer<String> warn) {}

    /** A key for the vehicle, or null to take its key away, and the time that its signatures begin with. */
    record Request(@Nullable LinkKey key, long timestamp) {}

    /** {@code links}: those that are bound to the drone now; others change the set at any time. */
    Keyring(LinkSecurity security, int systemId, InstantSource wall, Callbacks keeper, Set<LinkGuard> links) {
        this.drone = security.drone();
        this.links = links;
        this.systemId = systemId;
        this.keeper = keeper;
        // Ahead of the clock when stopped: up to a minute of it may not have been stored.
        boolean ahead = security.stamp() > SigningClock.timestampOf(wall.instant());
        clock = new SigningClock(wall, ahead ? security.stamp() + MINUTE : security.stamp());
        policy = security.policy();
        current = held(security.key());
        next = held(security.nextKey());
        proven = security.proven();
    }

    private @Nullable ActiveKey held(@Nullable LinkKey key) {
        return key == null ? null : new ActiveKey(key, clock);
    }

    DroneId drone() {
        return drone;
    }

    synchronized LinkSecurity security() {
        return new LinkSecurity(drone, policy, keyOf(current), keyOf(next), proven, clock.now());
    }

    private static @Nullable LinkKey keyOf(@Nullable ActiveKey held) {
        return held == null ? null : held.key();
    }

    synchronized LinkSecurityStatus status() {
        LinkSecurity now = security();
        return new LinkSecurityStatus(
                policy,
                now.key() == null ? null : now.key().fingerprint(),
                proven,
                now.nextKey() == null ? null : now.nextKey().fingerprint(),
                change == null ? null : change.kind(),
                refusals.counts(),
                links.isEmpty() ? null : (Boolean) hasSafeLink());
    }

    synchronized boolean isRequired() {
        return policy == LinkSigningPolicy.REQUIRED;
    }

    /** Signatures count for something. */
    synchronized boolean isLookedAt() {
        return policy != LinkSigningPolicy.OFF;
    }

    /** One of the keys made this frame's signature, whenever that was. */
    synchronized boolean signed(Frame frame) {
        return frame.systemId() == systemId
                && ((current != null && current.signed(frame)) || (next != null && next.signed(frame)));
    }

    /** What becomes of a frame that came in this drone's name. */
    synchronized FrameAdmission admit(Frame frame, long nowNanos) {
        SignatureVerdict verdict = judge(frame, nowNanos);
        if (verdict.isValid()) {
            refusals.valid();
            return FrameAdmission.PROVEN;
        }
        boolean open = policy == LinkSigningPolicy.OFF
                || (policy == LinkSigningPolicy.OPTIONAL && (verdict == SignatureVerdict.UNSIGNED || !proven))
                || (verdict == SignatureVerdict.UNSIGNED && change != null && change.kind() == KeyChangeKind.REVOKE);
        if (open) {
            return FrameAdmission.ADMITTED;
        }
        if (verdict == SignatureVerdict.UNSIGNED
                && (frame.messageId() == RadioStatus.ID || frame.messageId() == RADIO)) {
            return FrameAdmission.ASIDE;
        }
        refusals.refused(verdict, nowNanos).ifPresent(keeper.warn());
        return FrameAdmission.REFUSED;
    }

    private SignatureVerdict judge(Frame frame, long nowNanos) {
        if (!frame.signed()) {
            verifiedDuringChange(frame, KeyChange.Use.NONE, nowNanos);
            return SignatureVerdict.UNSIGNED;
        }
        SignatureVerdict verdict = verdict(current, frame);
        KeyChange.Use use = KeyChange.Use.OLD;
        if (verdict.isValid()) {
            use = change != null && change.kind() == KeyChangeKind.INSTALL ? KeyChange.Use.NEW : use;
            prove();
        } else if (verdict == SignatureVerdict.BAD_SIGNATURE) {
            verdict = verdict(next, frame);
            if (verdict.isValid()) {
                use = KeyChange.Use.NEW;
                adopt(nowNanos);
            } else if (verdict == SignatureVerdict.BAD_SIGNATURE && nowNanos - previousUntilNanos < 0) {
                verdict = verdict(previous, frame);
            }
        }
        if (verdict.isValid()) {
            verifiedDuringChange(frame, use, nowNanos);
        }
        return verdict;
    }

    private void verifiedDuringChange(Frame frame, KeyChange.Use use, long nowNanos) {
        if (change != null && frame.verified()) {
            change.received(use, nowNanos);
            settle();
        }
    }

    private static SignatureVerdict verdict(@Nullable ActiveKey held, Frame frame) {
        return held == null ? SignatureVerdict.BAD_SIGNATURE : held.judge(frame);
    }

    private void prove() {
        if (!proven) {
            proven = true;
            keep();
        }
    }

    /** The vehicle signs with the next key: that is the key now; what it sent before may still be on its way. */
    private void adopt(long nowNanos) {
        previous = current;
        previousUntilNanos = nowNanos + GRACE_NANOS;
        current = next;
        next = null;
        proven = true;
        keep();
    }

    private void keep() {
        keeper.keep().accept(security(), () -> {});
    }

    /** Signs what goes out; null without a key. */
    synchronized @Nullable FrameSigner signer(int linkId) {
        if (current == null) {
            return null;
        }
        FrameSigner signer = current.signer(linkId);
        return frame -> {
            synchronized (this) {
                signer.sign(frame);
            }
        };
    }

    synchronized boolean holds(long nowNanos) {
        return change != null && change.holds(nowNanos);
    }

    synchronized void textReceived(String text) {
        if (change != null) {
            change.textReceived(text);
            settle();
        }
    }

    /** What is to be sent to the vehicle now, over this link; null: nothing. */
    synchronized @Nullable Request advance(LinkGuard link, long nowNanos) {
        if (current != null && (stampedNanos == 0 || nowNanos - stampedNanos > STAMP_NANOS)) {
            stampedNanos = nowNanos;
            keeper.stamp().accept(security());
        }
        KeyChange now = change;
        if (now == null || !(link.isSafe() || changeConfirmed)) {
            return null;
        }
        boolean due = now.due(nowNanos);
        settle();
        if (!due) {
            return null;
        }
        LinkKey wanted = keyOf(now.kind() == KeyChangeKind.ROTATE ? next : current);
        return now.kind() == KeyChangeKind.REVOKE || wanted == null
                ? new Request(null, 0)
                : new Request(wanted, clock.next());
    }

    private boolean hasSafeLink() {
        return links.stream().anyMatch(LinkGuard::isSafe);
    }

    synchronized void bound(int newSystemId) {
        systemId = newSystemId;
    }

    synchronized void setPolicy(LinkSigningPolicy wanted) {
        policy = wanted;
    }

    /** A key that no vehicle has yet; false when the present one is in use. */
    synchronized boolean put(LinkKey key) {
        if (proven || change != null) {
            return false;
        }
        current = held(key);
        next = null;
        if (policy == LinkSigningPolicy.OFF) {
            policy = LinkSigningPolicy.OPTIONAL;
        }
        return true;
    }

    /** Forgets every key and asks for none. */
    synchronized void clear() {
        current = null;
        next = null;
        previous = null;
        proven = false;
        policy = LinkSigningPolicy.OFF;
    }

    /** Why a change cannot begin now; null: it can. */
    synchronized KeyChangeResult.@Nullable Failed obstacle(KeyChangeKind kind, boolean confirmed) {
        if (change != null) {
            return new KeyChangeResult.Failed(
                    KeyChangeFault.CHANGING, "The key of this drone is being changed already.");
        }
        if (current == null) {
            return new KeyChangeResult.Failed(KeyChangeFault.NO_KEY, "There is no key for this drone; make one first.");
        }
        if (kind == KeyChangeKind.ROTATE && !proven) {
            return new KeyChangeResult.Failed(
                    KeyChangeFault.NOT_PROVEN, "The vehicle was never heard using its key; install that first.");
        }
        if (links.isEmpty()) {
            return new KeyChangeResult.Failed(KeyChangeFault.NO_LINK, "The drone has no link now.");
        }
        if (kind != KeyChangeKind.REVOKE && !confirmed && !hasSafeLink()) {
            return new KeyChangeResult.Failed(
                    KeyChangeFault.LINK_NOT_SAFE,
                    "The link could be listened to, and who hears the key can command the drone. Use a serial line, DTLS"
                            + " or a connection on this machine, or confirm that this link is safe.");
        }
        return null;
    }

    /** Begins once {@code newKey} is durable; it is null but for a rotation. */
    synchronized CompletableFuture<KeyChangeResult> begin(
            KeyChangeKind kind, @Nullable LinkKey newKey, boolean confirmed) {
        next = newKey == null ? next : held(newKey);
        change = new KeyChange(kind);
        changeConfirmed = confirmed || kind == KeyChangeKind.REVOKE;
        changeEnd = new CompletableFuture<>();
        return changeEnd;
    }

    private void settle() {
        KeyChangeResult result = change == null ? null : change.result();
        if (change == null || result == null) {
            return;
        }
        KeyChangeKind kind = change.kind();
        change = null;
        if (result instanceof KeyChangeResult.Done && kind == KeyChangeKind.REVOKE) {
            clear();
        } else if (result instanceof KeyChangeResult.Failed && kind == KeyChangeKind.ROTATE) {
            next = null;
        }
        CompletableFuture<KeyChangeResult> end = changeEnd;
        keeper.keep().accept(security(), () -> end.complete(result));
    }
}

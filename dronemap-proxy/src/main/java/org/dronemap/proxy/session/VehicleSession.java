package org.dronemap.proxy.session;

import java.util.Optional;
import java.util.concurrent.RejectedExecutionException;
import org.dronemap.core.cloud.DroneLink;
import org.dronemap.core.cloud.SendAuthority;
import org.dronemap.core.cloud.VehicleChannel;
import org.dronemap.core.cloud.lane.Lane;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.command.Setpoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.SetupSigning;
import org.dronemap.proxy.signing.FrameAdmission;
import org.dronemap.proxy.signing.LinkGuard;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The server's session with one MAVLink vehicle over all its links, from its first message until it is gone. Begins on
 * the registry lane, asks who it is, binds to a drone and moves to the drone's lane, or hands its link to the session
 * that speaks for that drone already; everything but {@link #offer}, {@link #played} and {@link #vanish} belongs to the
 * lane where it is.
 */
final class VehicleSession implements VehicleChannel, Lane.TimedTask {
    private static final Logger LOG = LoggerFactory.getLogger(VehicleSession.class);
    private static final long SECOND_NANOS = 1_000_000_000L;
    private static final long STRANGER_GIVEN_UP_NANOS = 10 * SECOND_NANOS;
    private static final long GIVEN_UP_NANOS = 120 * SECOND_NANOS;
    private static final long TALKATIVE_NANOS = 3 * SECOND_NANOS;

    private final SessionDependencies surroundings;
    private final LinkOrigin label;
    private final LinkSelector links;
    private final DuplicateFrameFilter echoes = new DuplicateFrameFilter();
    private final LinkGuard guard;
    private final Runnable onEnd;
    private final FrameTap tap;
    private final SessionFrameQueue mailbox;
    private final int componentId;
    private final AutopilotChannel conversation;
    private final DroneBinder introduction;
    private final EarlyEvents news = new EarlyEvents();
    private Lane lane;
    private volatile @Nullable DroneLink link;
    private boolean moving;
    private long lastReceivedNanos;
    private volatile @Nullable VehicleSession carriedOnBy;
    private final AutopilotTakeover takeover = new AutopilotTakeover();
    private volatile boolean ended;
    private volatile boolean vanished;
    private volatile boolean played;

    /** {@code first} made the session; {@code onEnd} hears once that it is over. */
    VehicleSession(SessionDependencies surroundings, VehicleLink firstLink, Frame first, Runnable onEnd) {
        this.surroundings = surroundings;
        this.label = firstLink.label();
        this.links = new LinkSelector(firstLink);
        this.onEnd = onEnd;
        guard = surroundings.keyrings().guard(label.signingLinkId(), links::isSafe);
        firstLink.downlink().guardedBy(guard);
        componentId = first.componentId();
        tap = label.replay() ? FrameTap.NONE : surroundings.taps().open(componentId);
        firstLink.downlink().tapBy(tap);
        conversation = new AutopilotChannel(links, first, this::publish, tap::missionRead, surroundings.nanoTime());
        introduction = new DroneBinder(surroundings, links, conversation);
        lane = surroundings.lanes().registry();
        String mark = label.peer().text();
        mailbox = new SessionFrameQueue(
                lane, frame -> surroundings.watch().atWork().at(mark, () -> process(frame)));
        lastReceivedNanos = surroundings.now();
        Lane registry = lane;
        registry.execute(() -> registry.addTimedTask(this));
    }

    /** Takes a frame in; false when there was no room. Any thread. */
    boolean offer(Frame frame) {
        tap.received(frame);
        return mailbox.offer(frame);
    }

    /** True when it is over and a new heartbeat makes a new session. Any thread. */
    boolean isOver() {
        return ended;
    }

    private void process(Frame frame) {
        VehicleSession older = carriedOnBy;
        if (older != null) {
            older.carryOn(frame, lane);
            return;
        }
        long now = surroundings.now();
        FrameAdmission admission = admit(frame, now);
        if (admission == FrameAdmission.REFUSED) {
            return;
        }
        tap.admitted(frame);
        if (frame.componentId() != componentId || admission == FrameAdmission.ASIDE) {
            // Other components speak for themselves; their sentences are shown while the autopilot lives.
            if (now - lastReceivedNanos < 2 * SECOND_NANOS) {
                conversation.receivedFromComponent(frame, now);
            }
            return;
        }
        dispatch(frame, now);
        if (link == null && !ended) {
            claimWhenKnown(now);
        }
    }

    /** A frame that still came to the session which handed its link over, and is now on that lane. */
    private void carryOn(Frame frame, Lane here) {
        if (here == lane) {
            process(frame);
        } else {
            mailbox.offer(frame);
        }
    }

    private FrameAdmission admit(Frame frame, long now) {
        if (label.replay()) {
            return FrameAdmission.ADMITTED;
        }
        if (links.isRedundant() && echoes.isEcho(frame)) {
            return FrameAdmission.REFUSED;
        }
        FrameAdmission admission = guard.judge(frame, now);
        guard.signer().ifPresent(links.best()::signedBy);
        if (guard.contradicts()) {
            loseDrone("The key of another drone signs on this link; look at the drone.");
        }
        return admission;
    }

    /** A frame of the autopilot itself. */
    private void dispatch(Frame frame, long now) {
        lastReceivedNanos = now;
        DroneLink bound = stillBound();
        if (ended) {
            return;
        }
        if (bound != null && frame.verified()) {
            bound.received(AutopilotChannel.pace(frame));
        }
        if (bound != null && introduction.contradicts(frame) && !staysBound(bound, now)) {
            return;
        }
        if (label.replay()) {
            conversation.replayed(frame, now);
        } else {
            conversation.received(frame, now);
        }
    }

    /** Null when its drone was removed, or answers to another session. */
    private @Nullable DroneLink stillBound() {
        DroneLink bound = link;
        if (bound == null || !bound.isGone()) {
            return bound;
        }
        loseDrone(takeover.why("Another link now speaks for the vehicle; look at the drone."));
        if (label.replay()) {
            end();
        }
        return null;
    }

    /** A vehicle that says only later what hardware it has, or another one than before, is judged anew. */
    private boolean staysBound(DroneLink bound, long now) {
        DroneLink found = introduction.claim(this, guard, now);
        if (found != null && found.id().equals(bound.id())) {
            return true;
        }
        loseDrone("The vehicle at this address turned out to be another one.");
        bound.withdraw();
        if (found != null) {
            moveTo(found);
        }
        return false;
    }

    private void loseDrone(String why) {
        conversation.abandon(why);
        takeover.end(other -> other.lane == lane && other.drone().equals(drone()));
        guard.unbound();
        link = null;
    }

    @Override
    public void advance() {
        long now = surroundings.now();
        if (moving) {
            return;
        }
        if (carriedOnBy != null) {
            end();
            return;
        }
        SetupSigning key = guard.advance(label.key().systemId(), componentId, now);
        if (key != null) {
            links.sendSecret(key);
        }
        conversation.advance(now);
        takeover.advance(now);
        if (!label.replay()) {
            introduction.talk(now, now - lastReceivedNanos < TALKATIVE_NANOS, link != null);
        }
        DroneLink bound = stillBound();
        boolean news = links.advance(now);
        if (bound != null) {
            report(bound, news);
        }
        long patience = bound == null || vanished ? STRANGER_GIVEN_UP_NANOS : GIVEN_UP_NANOS;
        if (now - lastReceivedNanos > patience && conversation.isIdle()) {
            withdrawReplaced(bound);
            end();
        } else if (bound == null && !ended) {
            claimWhenKnown(now);
        }
    }

    /** The drone that was made for somebody who is none. */
    private void withdrawReplaced(@Nullable DroneLink bound) {
        if (vanished && bound != null) {
            loseDrone("Another component of the vehicle is its autopilot; look at the drone.");
            bound.withdraw();
        }
    }

    private void report(DroneLink bound, boolean linkNews) {
        if (linkNews) {
            bound.linkChanged(links.report());
        }
        if (played) {
            bound.replayEnded();
        }
        if (!introduction.publishProof(bound)) {
            end();
        }
    }

    private void claimWhenKnown(long now) {
        if (vanished || now - lastReceivedNanos > TALKATIVE_NANOS || !introduction.isDue(now)) {
            return;
        }
        DroneLink found = introduction.claim(this, guard, now);
        if (found != null) {
            moveTo(found);
        }
    }

    /** On the drone's lane, where both are now or arrive next. */
    @Override
    public boolean supersedes(VehicleChannel newer) {
        if (!(newer instanceof VehicleSession other) || other == this || ended || label.replay() || !isLike(other)) {
            return false;
        }
        VehicleLink joining = other.links.best();
        links.join(joining);
        joining.downlink().guardedBy(guard);
        joining.downlink().tapBy(tap);
        joining.belongsTo(this);
        other.carriedOnBy = this;
        lastReceivedNanos = surroundings.now();
        return true;
    }

    /** Speaks as the same autopilot: what is under way here can go on there. */
    private boolean isLike(VehicleSession other) {
        return other.componentId == componentId
                && other.label.key().systemId() == label.key().systemId()
                && other.conversation
                        .autopilot()
                        .vehicle()
                        .equals(conversation.autopilot().vehicle());
    }

    /** The last thing that happens on the old lane. */
    private void moveTo(DroneLink bound) {
        Lane from = lane;
        Lane to = bound.lane();
        moving = true;
        lane = to;
        from.removeTimedTask(this);
        try {
            to.execute(() -> arrive(bound));
        } catch (RejectedExecutionException e) {
            LOG.warn("The lane of {} had no room for its session; it will try again", bound.id(), e);
            moving = false;
            lane = from;
            from.addTimedTask(this);
            return;
        }
        mailbox.moveTo(to);
    }

    private void arrive(DroneLink bound) {
        moving = false;
        if (carriedOnBy != null) {
            end();
            return;
        }
        link = bound;
        guard.bound(bound.id(), label.key().systemId());
        tap.bound(bound.id());
        if (vanished) {
            bound.disconnect();
            end();
            return;
        }
        lane.addTimedTask(this);
        bound.received(conversation.firstPace());
        conversation.begin(surroundings.now());
        news.publishTo(bound);
    }

    private void publish(DroneEvent event) {
        if (event instanceof DroneEvent.TextReported text) {
            guard.textReceived(text.text());
        }
        DroneLink bound = link;
        if (bound != null) {
            bound.accept(event);
        }
        news.add(event, bound != null);
    }

    /** The drone that it speaks for, once bound. Any thread. */
    Optional<DroneId> drone() {
        DroneLink bound = link;
        return bound == null ? Optional.empty() : Optional.of(bound.id());
    }

    /** Messages that wait to be read. Any thread. */
    int waiting() {
        return mailbox.waiting();
    }

    /** Its recording is over. Any thread. */
    void played() {
        played = true;
    }

    /** Nothing more will come: a recording is taken away, and its drone with it, or another session speaks. Any thread. */
    void vanish(boolean asPart) {
        vanished = true;
        Optional.ofNullable(link).ifPresent(asPart ? DroneLink::becamePart : DroneLink::disconnect);
    }

    /** That session of the autopilot will speak for the drone; {@code asPart}: this one was a part of it. Any thread. */
    void replacedBy(@Nullable VehicleSession autopilot, boolean asPart) {
        takeover.begin(autopilot);
        vanish(asPart);
    }

    @Override
    public boolean isOtherComponent(VehicleChannel older) {
        return older instanceof VehicleSession other && other.componentId != componentId;
    }

    private void end() {
        if (!ended) {
            ended = true;
            guard.leave();
            lane.removeTimedTask(this);
            tap.ended();
            onEnd.run();
        }
    }

    @Override
    public void perform(SendAuthority mandate, Command command, Report report) {
        if (!takeover.keeps(mandate, command, report, surroundings.now())) {
            conversation.perform(mandate, command, report);
        }
    }

    @Override
    public void steer(SendAuthority mandate, Setpoint setpoint) {
        conversation.steer(mandate, setpoint);
    }

    @Override
    public void cancel(CommandId id) {
        takeover.cancel(id);
        conversation.cancel(id, surroundings.now());
    }

    @Override
    public void probe() {
        conversation.probe();
    }
}

package org.dronemap.proxy.session;

import java.util.Optional;
import java.util.concurrent.RejectedExecutionException;
import org.dronemap.core.cloud.DroneLink;
import org.dronemap.core.cloud.Lane;
import org.dronemap.core.cloud.LinkSession;
import org.dronemap.core.cloud.VehicleChannel;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandId;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.mavlink.Frame;
import org.dronemap.mavlink.message.CommandLong;
import org.dronemap.mavlink.message.Heartbeat;
import org.dronemap.mavlink.message.SetupSigning;
import org.dronemap.proxy.mavlink.procedure.MessageRates;
import org.dronemap.proxy.mavlink.procedure.Observer;
import org.dronemap.proxy.mavlink.procedure.RoundTripProbe;
import org.dronemap.proxy.mavlink.procedure.Target;
import org.dronemap.proxy.mavlink.translate.Autopilot;
import org.dronemap.proxy.mavlink.translate.Cockpit;
import org.dronemap.proxy.mavlink.translate.Identity;
import org.dronemap.proxy.mavlink.translate.ParameterTable;
import org.dronemap.proxy.mavlink.translate.Telemetry;
import org.dronemap.proxy.mavlink.translate.VehicleStatus;
import org.dronemap.proxy.signing.Admission;
import org.dronemap.proxy.signing.LinkGuard;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * One vehicle on one link. Begins on the registry lane, asks who it is, binds to a drone and moves to the drone's lane;
 * everything but {@link #offer}, {@link #played} and {@link #vanish} belongs to the lane where it is.
 */
final class VehicleSession implements VehicleChannel, Lane.Ticker {
    private static final Logger LOG = LoggerFactory.getLogger(VehicleSession.class);
    private static final long SECOND_NANOS = 1_000_000_000L;
    private static final long IDENTITY_PATIENCE_NANOS = SECOND_NANOS;
    private static final long BETWEEN_IDENTITY_ASKS_NANOS = 400_000_000L;
    private static final long IDENTITY_LATER_NANOS = 5 * SECOND_NANOS;
    private static final int IDENTITY_ASKS = 8;
    private static final long GIVEN_UP_NANOS = 120 * SECOND_NANOS;
    private static final long TALKATIVE_NANOS = 3 * SECOND_NANOS;
    private static final int REQUEST_MESSAGE = 512;
    private static final int REQUEST_CAPABILITIES = 520;
    private static final int AUTOPILOT_VERSION = 148;
    static final Heartbeat OWN_HEARTBEAT = new Heartbeat(6, 8, 0, 0, 4, 3);

    private final Surroundings surroundings;
    private final LinkLabel label;
    private final Downlink downlink;
    private final LinkGuard guard;
    private final Runnable onEnd;
    private final FrameTap tap;
    private final Mailbox mailbox;
    private final int componentId;
    private final Target target;
    private final Autopilot autopilot;
    private final VehicleStatus status;
    private final Telemetry telemetry;
    private final ParameterTable parameters;
    private final Errands errands = new Errands();
    private final MessageRates rates;
    private final MissionWatch missions;
    private final LinkMeter meter;
    private final EarlyNews news = new EarlyNews();
    private final long bornNanos;
    private Lane lane;
    private volatile @Nullable DroneLink link;
    private boolean moving;
    private long lastHeardNanos;
    private long lastHeartbeatNanos;
    private long lastIdentityAskNanos;
    private int identityAsks;
    private long notBindBeforeNanos;
    private volatile boolean ended;
    private volatile boolean vanished;
    private volatile boolean played;

    /** {@code first} made the session; {@code onEnd} hears once that it is over. */
    VehicleSession(Surroundings surroundings, LinkLabel label, Downlink downlink, Frame first, Runnable onEnd) {
        this.surroundings = surroundings;
        this.label = label;
        this.downlink = downlink;
        this.onEnd = onEnd;
        guard = surroundings.keyrings().guard(label.signingLinkId(), downlink.isSafe());
        downlink.guardedBy(guard);
        Heartbeat heartbeat = Heartbeat.decode(first);
        componentId = first.componentId();
        tap = label.replay() ? FrameTap.NONE : surroundings.taps().open(componentId);
        downlink.tapBy(tap);
        target = new Target(first.systemId(), componentId, this::send);
        autopilot = Autopilot.of(heartbeat);
        status = new VehicleStatus(heartbeat.type());
        telemetry = new Telemetry(autopilot, status, this::tell);
        parameters = new ParameterTable(autopilot, this::tell);
        rates = new MessageRates(target);
        missions = new MissionWatch(target, autopilot, status, this::tell);
        bornNanos = surroundings.now();
        meter = new LinkMeter(new RoundTripProbe(target, target.roundTrip()), bornNanos);
        lane = surroundings.lanes().registry();
        mailbox = new Mailbox(lane, this::take);
        lastHeardNanos = bornNanos;
        lastHeartbeatNanos = bornNanos - SECOND_NANOS;
        lastIdentityAskNanos = bornNanos - BETWEEN_IDENTITY_ASKS_NANOS;
        notBindBeforeNanos = bornNanos;
        Lane registry = lane;
        registry.execute(() -> registry.addTicker(this));
    }

    /** Takes a frame in as its link brought it; false when there was no room. On the endpoint's thread. */
    boolean arrived(Frame frame) {
        meter.arrived(frame, surroundings.now());
        return offer(frame);
    }

    /** Takes a frame in out of its order; false when there was no room. Any thread. */
    boolean offer(Frame frame) {
        tap.heard(frame);
        return mailbox.offer(frame);
    }

    /** True when it is over and a new heartbeat makes a new session. Any thread. */
    boolean isOver() {
        return ended;
    }

    private void take(Frame frame) {
        long now = surroundings.now();
        Admission admission = admit(frame, now);
        if (admission == Admission.REFUSED) {
            return;
        }
        if (frame.componentId() != componentId || admission == Admission.ASIDE) {
            // Other components speak for themselves; their sentences are shown while the autopilot lives.
            if (now - lastHeardNanos < 2 * SECOND_NANOS) {
                telemetry.overheard(frame, now);
            }
            return;
        }
        hear(frame, now);
    }

    private Admission admit(Frame frame, long now) {
        Admission admission = label.replay() ? Admission.ADMITTED : guard.judge(frame, now);
        if (guard.contradicts()) {
            loseDrone();
        }
        return admission;
    }

    private void hear(Frame frame, long now) {
        lastHeardNanos = now;
        downlink.heardVersion(frame.version());
        DroneLink bound = link;
        if (bound != null && bound.isGone()) {
            if (label.replay()) {
                end();
                return;
            }
            loseDrone();
            bound = null;
        }
        if (bound != null && frame.verified()) {
            bound.heard();
        }
        telemetry.heard(frame, now);
        parameters.heard(frame);
        errands.heard(frame, now);
        if (!label.replay()) {
            meter.heard(frame, now);
            rates.heard(frame, now);
            missions.heard(frame, now, errands.transferring());
        }
        if (link == null) {
            bindWhenKnown(now);
        }
    }

    private void loseDrone() {
        guard.unbound();
        link = null;
    }

    @Override
    public void tick() {
        long now = surroundings.now();
        if (moving) {
            return;
        }
        SetupSigning key = guard.tick(target.systemId(), componentId, now);
        if (key != null) {
            downlink.sendSecret(key);
        }
        downlink.tick(now);
        telemetry.tick(now);
        errands.tick(now);
        if (!label.replay()) {
            talk(now);
        }
        DroneLink bound = link;
        if (meter.tick(now) && bound != null) {
            bound.measured(meter.quality());
        }
        if (played && bound != null) {
            bound.played();
        }
        if (link == null && !ended) {
            bindWhenKnown(now);
        }
        endWhenGivenUp(now);
    }

    /** Also one that was never bound, because it speaks in the name of a drone whose key it does not have. */
    private void endWhenGivenUp(long now) {
        if (!moving && now - lastHeardNanos > GIVEN_UP_NANOS && errands.isEmpty()) {
            end();
        }
    }

    private void talk(long now) {
        if (now - lastHeartbeatNanos >= SECOND_NANOS) {
            lastHeartbeatNanos = now;
            send(OWN_HEARTBEAT);
        }
        boolean talkative = now - lastHeardNanos < TALKATIVE_NANOS;
        if (talkative) {
            askIdentity(now);
        }
        if (talkative && link != null) {
            meter.ask(now);
            rates.tick(now);
            missions.tick(now, errands.transferring());
        }
    }

    private void askIdentity(long now) {
        long pause = link == null ? BETWEEN_IDENTITY_ASKS_NANOS : IDENTITY_LATER_NANOS;
        if (status.version() != null || identityAsks >= IDENTITY_ASKS || now - lastIdentityAskNanos < pause) {
            return;
        }
        lastIdentityAskNanos = now;
        identityAsks++;
        send(command(REQUEST_MESSAGE, AUTOPILOT_VERSION));
        send(command(REQUEST_CAPABILITIES, 1));
    }

    private CommandLong command(int number, int parameter) {
        return new CommandLong(target.systemId(), target.componentId(), number, 0, parameter, 0f, 0f, 0f, 0f, 0f, 0f);
    }

    private void bindWhenKnown(long now) {
        boolean known = label.replay() || status.version() != null || now - bornNanos >= IDENTITY_PATIENCE_NANOS;
        if (!known || vanished || now - notBindBeforeNanos < 0 || now - lastHeardNanos > TALKATIVE_NANOS) {
            return;
        }
        notBindBeforeNanos = now + SECOND_NANOS;
        Identification identification = Identity.of(autopilot, status.type(), status.version());
        if (!label.replay() && !guard.mayBind(surroundings.cloud().recognise(label.key(), identification))) {
            return;
        }
        LinkSession session = new LinkSession(
                label.key(), label.transport(), label.replay(), autopilot.vehicle() + " " + target.systemId(), this);
        moveTo(surroundings
                .cloud()
                .connect(session, identification, guard.signer().orElse(null)));
    }

    /** The last thing that happens on the old lane. */
    private void moveTo(DroneLink bound) {
        Lane from = lane;
        Lane to = bound.lane();
        moving = true;
        lane = to;
        from.removeTicker(this);
        try {
            to.execute(() -> arrive(bound));
        } catch (RejectedExecutionException e) {
            LOG.warn("The lane of {} had no room for its session; it will try again", bound.id(), e);
            moving = false;
            lane = from;
            from.addTicker(this);
            return;
        }
        mailbox.moveTo(to);
    }

    private void arrive(DroneLink bound) {
        moving = false;
        link = bound;
        guard.bound(bound.id(), target.systemId());
        tap.bound(bound.id());
        if (vanished) {
            bound.disconnect();
            end();
            return;
        }
        lane.addTicker(this);
        telemetry.identified();
        news.tellTo(bound);
        missions.begin(surroundings.now());
    }

    private void tell(DroneEvent event) {
        if (event instanceof DroneEvent.TextHeard text) {
            errands.said(text.severity(), text.text(), surroundings.now());
            guard.said(text.text());
        }
        DroneLink bound = link;
        if (bound != null) {
            bound.accept(event);
        }
        news.heard(event, bound != null);
    }

    private void send(org.dronemap.mavlink.Message message) {
        if (!label.replay()) {
            downlink.send(message, surroundings.now());
        }
    }

    /** The drone that it speaks for, once bound. Any thread. */
    Optional<DroneId> drone() {
        DroneLink bound = link;
        return bound == null ? Optional.empty() : Optional.of(bound.id());
    }

    /** Messages missing so far. Any thread. */
    long lost() {
        return meter.counts().lost();
    }

    /** What went over its link so far. Any thread. */
    VehicleTraffic traffic() {
        return VehicleTraffic.of(label, drone(), meter.counts(), downlink.sent(), mailbox);
    }

    /** Its recording is over. Any thread. */
    void played() {
        played = true;
    }

    /** A recording is taken away, and its drone with it. Any thread. */
    void vanish() {
        vanished = true;
        DroneLink bound = link;
        if (bound != null) {
            bound.disconnect();
        }
    }

    private void end() {
        if (!ended) {
            ended = true;
            guard.leave();
            lane.removeTicker(this);
            tap.ended();
            onEnd.run();
        }
    }

    @Override
    public void perform(CommandId id, Command command, Report report) {
        Observer observer = new Observer() {
            @Override
            public void accepted() {
                report.accepted();
            }

            @Override
            public void progress(int done, int total) {
                report.progress(done, total);
            }
        };
        Cockpit cockpit = new Cockpit(
                status, parameters, target, observer, this::tell, missions::changedByCloud, telemetry::remark);
        errands.begin(id, command, autopilot.plan(command, cockpit), report, surroundings.now());
    }

    @Override
    public void cancel(CommandId id) {
        errands.cancel(id, surroundings.now());
    }

    @Override
    public void probe() {
        send(command(REQUEST_MESSAGE, Heartbeat.ID));
    }
}

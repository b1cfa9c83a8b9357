package org.dronemap.core.cloud;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.List;
import org.dronemap.core.drone.Attitude;
import org.dronemap.core.drone.Battery;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneRecord;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.Gps;
import org.dronemap.core.drone.Home;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkReport;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LinkStatus;
import org.dronemap.core.drone.LocalPosition;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.OnBoard;
import org.dronemap.core.drone.Payload;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.ReturnHeight;
import org.dronemap.core.drone.Sensed;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.drone.Standing;
import org.dronemap.core.drone.TextMessage;
import org.dronemap.core.drone.Wind;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.parameter.ParameterSet;
import org.jspecify.annotations.Nullable;

/** The facts of one drone as they come in. Owned by the drone's lane; {@link #state()} may be read from anywhere. */
final class Drone {
    private static final Duration BETWEEN_SIGNS = Duration.ofSeconds(1);

    private final Clock clock;
    private final DroneId id;
    private final boolean replay;
    private final MissionTracker mission;
    private final ArrayDeque<TextMessage> messages = new ArrayDeque<>();
    // What changes rarely is not copied for every picture.
    private List<TextMessage> told = List.of();
    private MissionProgress progress;
    private String name;
    private DroneKey key;
    private String transport;
    private LinkState linkState = LinkState.LOST;
    private @Nullable Instant lastHeard;
    private LinkQuality quality = LinkQuality.UNKNOWN;
    private List<DroneKey> otherKeys = List.of();
    private Standing standing;
    private Identification identification;
    private Capabilities capabilities = Capabilities.UNKNOWN;
    private @Nullable String mode;
    private @Nullable Boolean armed;
    private @Nullable Boolean readyToArm;
    private @Nullable FlightPhase phase;
    private @Nullable Position position;
    private @Nullable LocalPosition local;
    private @Nullable Motion motion;
    private @Nullable Attitude attitude;
    private @Nullable Battery battery;
    private @Nullable Gps gps;
    private @Nullable Home home;
    private @Nullable ReturnHeight returnHeight;
    private Payload payload = Payload.UNKNOWN;
    private long version;
    private volatile DroneState state;
    private volatile OnBoard onBoard = OnBoard.UNKNOWN;
    private volatile Sensed sensed = Sensed.NOTHING;

    Drone(DroneRecord record, boolean replay, MissionTracker mission, Clock clock) {
        this.clock = clock;
        this.id = record.id();
        this.name = record.name();
        this.key = record.key();
        this.transport = record.transport();
        this.identification = record.identification();
        this.standing = record.standing();
        this.lastHeard = record.lastHeard();
        this.replay = replay;
        this.mission = mission;
        this.progress = mission.progress();
        this.state = snapshot();
    }

    DroneState state() {
        return state;
    }

    /** What the vehicle keeps on board beside its mission. Any thread. */
    OnBoard onBoard() {
        return onBoard;
    }

    /** The newest that its sensors brought. Any thread. */
    Sensed sensed() {
        return sensed;
    }

    DroneRecord record() {
        DroneState now = state;
        Instant heard = now.link().lastHeard();
        return new DroneRecord(
                id,
                now.name(),
                now.link().key(),
                now.link().transport(),
                now.identification(),
                now.standing(),
                heard == null ? now.lastUpdate() : heard);
    }

    MissionTracker mission() {
        return mission;
    }

    void rename(String newName) {
        name = newName;
        publish();
    }

    void attach(LinkSession session, Standing shown) {
        key = session.key();
        transport = session.transport();
        quality = LinkQuality.UNKNOWN;
        otherKeys = List.of();
        standing = shown;
        publish();
    }

    void heard() {
        lastHeard = clock.instant();
    }

    /**
     * It was heard by now, with or without news: says so once a second at most, as a sign of life alone makes no new state.
     * True when the state is new.
     */
    boolean showsHeard() {
        Instant shown = state.link().lastHeard();
        Instant now = lastHeard;
        if (now == null || (shown != null && Duration.between(shown, now).abs().compareTo(BETWEEN_SIGNS) < 0)) {
            return false;
        }
        publish();
        return true;
    }

    void standing(Standing now) {
        standing = now;
        publish();
    }

    void reached(LinkReport report) {
        key = report.key();
        transport = report.transport();
        quality = report.quality();
        otherKeys = report.others();
        publish();
    }

    /** A new version for what is shown beside the state. */
    void touch() {
        publish();
    }

    /** True when that is news. */
    boolean linkState(LinkState now) {
        if (now == linkState) {
            return false;
        }
        linkState = now;
        publish();
        return true;
    }

    /** Adds a sentence of the cloud's own about this drone. */
    void say(Severity severity, String text) {
        addText(severity, text);
        publish();
    }

    void apply(DroneEvent event) {
        if (event instanceof DroneEvent.PositionHeard e) {
            position = e.position();
        } else if (event instanceof DroneEvent.LocalPositionHeard e) {
            local = e.position();
        } else if (event instanceof DroneEvent.AttitudeHeard e) {
            attitude = e.attitude();
        } else if (event instanceof DroneEvent.MotionHeard e) {
            motion = e.motion();
        } else if (event instanceof DroneEvent.BatteryHeard e) {
            battery = e.battery();
        } else if (event instanceof DroneEvent.GpsHeard e) {
            gps = e.gps();
        } else if (event instanceof DroneEvent.TextHeard e) {
            addText(e.severity(), e.text());
        } else {
            applyRare(event);
        }
        publish();
    }

    private void applyRare(DroneEvent event) {
        if (event instanceof DroneEvent.Identified e) {
            identification = e.identification();
            capabilities = e.capabilities();
        } else if (event instanceof DroneEvent.ModeHeard e) {
            mode = e.mode();
            armed = e.armed();
        } else if (event instanceof DroneEvent.ReadinessHeard e) {
            readyToArm = e.readyToArm();
        } else if (event instanceof DroneEvent.PhaseHeard e) {
            phase = e.phase();
        } else if (event instanceof DroneEvent.HomeHeard e) {
            home = e.home();
        } else if (event instanceof DroneEvent.ReturnHeightSet e) {
            returnHeight = e.height();
        } else if (event instanceof DroneEvent.PayloadHeard e) {
            payload = applied(e);
        } else if (event instanceof DroneEvent.OnBoardHeard e) {
            onBoard = applied(e);
        } else if (event instanceof DroneEvent.SensedHeard e) {
            sensed = applied(e);
        } else {
            mission.apply(event).ifPresent(sentence -> addText(Severity.WARNING, sentence));
            progress = mission.progress();
        }
    }

    private Payload applied(DroneEvent.PayloadHeard event) {
        if (event instanceof DroneEvent.PhotoHeard e) {
            return payload.with(new Payload.Photo(e.number(), clock.instant(), e.point()));
        }
        if (event instanceof DroneEvent.OutputsHeard e) {
            return payload.withOutputs(e.pulsesMicros());
        }
        if (event instanceof DroneEvent.WindHeard e) {
            return payload.with(new Wind(e.fromDegrees(), e.metersPerSecond(), clock.instant()));
        }
        return event instanceof DroneEvent.ReadingHeard e
                ? payload.with(new Payload.Reading(e.name(), e.value(), clock.instant()))
                : payload;
    }

    private OnBoard applied(DroneEvent.OnBoardHeard event) {
        if (event instanceof DroneEvent.ParametersRead e) {
            return onBoard.withParameters(ParameterSet.of(e.parameters(), clock.instant()));
        }
        if (event instanceof DroneEvent.ParameterHeard e) {
            return onBoard.withParameters(onBoard.parameters().with(e.parameter()));
        }
        if (event instanceof DroneEvent.LogsRead e) {
            return onBoard.withLogs(e.logs());
        }
        if (event instanceof DroneEvent.FenceRead e) {
            return onBoard.withFence(e.zones());
        }
        return event instanceof DroneEvent.RallyPointsRead e ? onBoard.withRallyPoints(e.points()) : onBoard;
    }

    private Sensed applied(DroneEvent.SensedHeard event) {
        Instant at = clock.instant();
        if (event instanceof DroneEvent.ScanHeard e) {
            return sensed.with(e.scan(), at);
        }
        if (event instanceof DroneEvent.PictureHeard e) {
            return sensed.with(e.picture(), at);
        }
        return event instanceof DroneEvent.MapHeard e ? sensed.with(e.map(), at) : sensed;
    }

    private void addText(Severity severity, String text) {
        if (messages.size() == DroneState.MAX_MESSAGES) {
            messages.removeFirst();
        }
        messages.addLast(new TextMessage(severity, text, clock.instant()));
        told = List.copyOf(messages);
    }

    private void publish() {
        version++;
        state = snapshot();
    }

    /** What was measured before a silence says nothing about the link after it. */
    private LinkStatus link() {
        boolean lost = linkState == LinkState.LOST;
        return new LinkStatus(key, transport, linkState, lastHeard, lost ? LinkQuality.UNKNOWN : quality, otherKeys);
    }

    private DroneState snapshot() {
        return new DroneState(
                id,
                name,
                replay,
                link(),
                identification,
                standing,
                capabilities,
                mode,
                armed,
                readyToArm,
                phase,
                position,
                local,
                motion,
                attitude,
                battery,
                gps,
                home,
                returnHeight,
                payload,
                progress,
                told,
                clock.instant(),
                version);
    }
}

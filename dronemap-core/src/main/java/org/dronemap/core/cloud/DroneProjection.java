package org.dronemap.core.cloud;

import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.List;
import java.util.Optional;
import org.dronemap.core.cloud.rule.GroundElevation;
import org.dronemap.core.cloud.rule.MissionTracker;
import org.dronemap.core.cloud.rule.StatePartAges;
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
import org.dronemap.core.drone.IdentityTrust;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkReport;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LinkStatus;
import org.dronemap.core.drone.LinkTrend;
import org.dronemap.core.drone.LocalPosition;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.Motion;
import org.dronemap.core.drone.OnboardStorage;
import org.dronemap.core.drone.PayloadState;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.ReturnHeight;
import org.dronemap.core.drone.SensorSnapshot;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.drone.TextMessage;
import org.dronemap.core.drone.Wind;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.parameter.ParameterSet;
import org.jspecify.annotations.Nullable;

/**
 * Builds the current state of one drone from the events of its vehicle. Owned by the drone's lane; {@link #state()} may
 * be read from anywhere.
 */
final class DroneProjection {
    private static final Duration BETWEEN_SIGNS = Duration.ofSeconds(1);

    private final Clock clock;
    private final DroneId id;
    private final boolean replay;
    private final MissionTracker mission;
    private final ArrayDeque<TextMessage> messages = new ArrayDeque<>();
    // What changes rarely is not copied for every picture.
    private List<TextMessage> messageSnapshot = List.of();
    private MissionProgress progress;
    private String name;
    private DroneKey key;
    private String transport;
    private LinkState linkState = LinkState.LOST;
    private @Nullable Instant lastHeard;
    private LinkQuality quality = LinkQuality.UNKNOWN;
    private LinkTrend trend = LinkTrend.UNKNOWN;
    private List<DroneKey> otherKeys = List.of();
    private final StatePartAges ages = new StatePartAges();
    private IdentityTrust standing;
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
    private PayloadState payload = PayloadState.UNKNOWN;
    private final GroundElevation ground;
    private long version;
    private volatile DroneState state;
    private volatile OnboardStorage onBoard = OnboardStorage.UNKNOWN;
    private volatile SensorSnapshot sensed = SensorSnapshot.NOTHING;

    DroneProjection(DroneRecord record, boolean replay, MissionTracker mission, Clock clock) {
        this.clock = clock;
        this.id = record.id();
        this.name = record.name();
        this.key = record.key();
        this.transport = record.transport();
        this.identification = record.identification();
        this.standing = record.standing();
        this.lastHeard = record.lastHeard();
        this.ground = new GroundElevation(record.groundAmslMeters());
        this.replay = replay;
        this.mission = mission;
        this.progress = mission.progress();
        this.state = snapshot();
    }

    DroneState state() {
        return state;
    }

    /** What the vehicle keeps on board beside its mission. Any thread. */
    OnboardStorage onBoard() {
        return onBoard;
    }

    /** The newest that its sensors brought. Any thread. */
    SensorSnapshot sensed() {
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
                heard == null ? now.lastUpdate() : heard,
                now.groundAmslMeters());
    }

    /** On the ground for certain. */
    private boolean stands() {
        return phase == null ? Boolean.FALSE.equals(armed) : phase == FlightPhase.ON_GROUND;
    }

    /** True once when what it left the ground with is to be remembered. */
    boolean leftTheGround() {
        return ground.isToBeKept(stands());
    }

    MissionTracker mission() {
        return mission;
    }

    void rename(String newName) {
        name = newName;
        publish();
    }

    void attach(LinkSession session, IdentityTrust shown) {
        key = session.key();
        transport = session.transport();
        quality = LinkQuality.UNKNOWN;
        trend = LinkTrend.UNKNOWN;
        otherKeys = List.of();
        standing = shown;
        publish();
    }

    void received() {
        lastHeard = clock.instant();
    }

    /**
     * It was heard by now, with or without news: says so once a second at most, as a sign of life alone makes no new state.
     * True when the state is new.
     */
    boolean publishReception() {
        Instant shown = state.link().lastHeard();
        Instant now = lastHeard;
        if (now == null || (shown != null && Duration.between(shown, now).abs().compareTo(BETWEEN_SIGNS) < 0)) {
            return false;
        }
        publish();
        return true;
    }

    /** True when the vehicle has stopped telling a part of its state, or tells it again: the state is new then. */
    boolean publishAges() {
        boolean silent = linkState == LinkState.LOST || linkState == LinkState.ENDED;
        boolean news = ages.judge(clock.instant(), silent);
        if (news) {
            publish();
        }
        return news;
    }

    /** It says all at once, now and then; {@code patience} zero: it speaks all the time. */
    void seldom(Duration patience) {
        ages.seldom(clock.instant(), patience);
    }

    void standing(IdentityTrust now) {
        standing = now;
        publish();
    }

    void reached(LinkReport report) {
        key = report.key();
        transport = report.transport();
        quality = report.quality();
        trend = report.trend();
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
    void publishMessage(Severity severity, String text) {
        publishMessage(severity, text, null);
    }

    /** The same, of one that names a user. */
    void publishMessage(Severity severity, String text, @Nullable String about) {
        addText(severity, text, about);
        publish();
    }

    /** What was said is not for those who look at it from now on. */
    void forgetMessages() {
        messages.clear();
        messageSnapshot = List.of();
        publish();
    }

    void apply(DroneEvent event) {
        Instant at = clock.instant();
        ages.apply(event, at);
        switch (event.kind()) {
            case IDENTIFIED -> identified((DroneEvent.Identified) event);
            case MODE -> mode((DroneEvent.ModeReported) event);
            case READINESS -> readyToArm = ((DroneEvent.ReadinessReported) event).readyToArm();
            case PHASE -> phase = ((DroneEvent.PhaseReported) event).phase();
            case POSITION -> position((DroneEvent.PositionReported) event);
            case LOCAL_POSITION -> local = ((DroneEvent.LocalPositionReported) event).position();
            case MOTION -> motion = ((DroneEvent.MotionReported) event).motion();
            case ATTITUDE -> attitude = ((DroneEvent.AttitudeReported) event).attitude();
            case BATTERY -> battery = ((DroneEvent.BatteryReported) event).battery();
            case GPS -> gps = ((DroneEvent.GpsReported) event).gps();
            case HOME -> home((DroneEvent.HomeReported) event);
            case RETURN_HEIGHT_SET -> returnHeight((DroneEvent.ReturnHeightSet) event);
            case MISSION_CURRENT -> mission(mission.apply((DroneEvent.MissionCurrentReported) event));
            case MISSION_ITEM_REACHED -> reached((DroneEvent.MissionItemReached) event);
            case MISSION_READ -> mission(mission.apply((DroneEvent.MissionRead) event));
            case PHOTO -> payload = payload.with(photo((DroneEvent.PhotoReported) event, at));
            case OUTPUTS -> payload = payload.withOutputs(((DroneEvent.OutputsReported) event).pulsesMicros());
            case READING -> payload = payload.with(reading((DroneEvent.ReadingReported) event, at));
            case WIND -> payload = payload.with(wind((DroneEvent.WindReported) event, at));
            case PARAMETERS_READ ->
                onBoard = onBoard.withParameters(ParameterSet.of(((DroneEvent.ParametersRead) event).parameters(), at));
            case PARAMETER ->
                onBoard = onBoard.withParameters(
                        onBoard.parameters().with(((DroneEvent.ParameterReported) event).parameter()));
            case LOGS_READ -> onBoard = onBoard.withLogs(((DroneEvent.LogsRead) event).logs());
            case FENCE_READ -> onBoard = onBoard.withFence(((DroneEvent.FenceRead) event).fence());
            case RALLY_POINTS_READ ->
                onBoard = onBoard.withRallyPoints(((DroneEvent.RallyPointsRead) event).rallyPoints());
            case SCAN -> sensed = sensed.with(((DroneEvent.ScanReported) event).scan(), at);
            case PICTURE -> sensed = sensed.with(((DroneEvent.PictureReported) event).picture(), at);
            case MAP -> sensed = sensed.with(((DroneEvent.MapReported) event).map(), at);
            case TEXT ->
                addText(((DroneEvent.TextReported) event).severity(), ((DroneEvent.TextReported) event).text(), null);
        }
        publish();
    }

    /** {@code meters} above home, as the cloud has set it for the time without the cloud; null: not known any more. */
    void returnsAt(@Nullable Double meters) {
        returnHeight = meters == null ? null : new ReturnHeight(meters, meters).after(returnHeight);
        publish();
    }

    private void returnHeight(DroneEvent.ReturnHeightSet set) {
        returnHeight = set.height().after(returnHeight);
    }

    private void position(DroneEvent.PositionReported event) {
        position = event.position();
        ground.at(event.position(), home, stands());
    }

    private void home(DroneEvent.HomeReported event) {
        Home told = event.home();
        home = told;
        if (told != null) {
            ground.at(told, stands());
        }
    }

    private void identified(DroneEvent.Identified event) {
        identification = event.identification();
        capabilities = event.capabilities();
    }

    private void mode(DroneEvent.ModeReported event) {
        mode = event.mode();
        if (event.armed() != null) {
            armed = event.armed();
        }
    }

    private void reached(DroneEvent.MissionItemReached event) {
        mission.apply(event);
        progress = mission.progress();
    }

    private void mission(Optional<String> news) {
        news.ifPresent(sentence -> addText(Severity.WARNING, sentence, null));
        progress = mission.progress();
    }

    private static PayloadState.Photo photo(DroneEvent.PhotoReported event, Instant at) {
        return new PayloadState.Photo(event.number(), at, event.point());
    }

    private static PayloadState.Reading reading(DroneEvent.ReadingReported event, Instant at) {
        return new PayloadState.Reading(event.name(), event.value(), at);
    }

    private static Wind wind(DroneEvent.WindReported event, Instant at) {
        return new Wind(event.fromDegrees(), event.metersPerSecond(), at);
    }

    private void addText(Severity severity, String text, @Nullable String about) {
        if (messages.size() == DroneState.MAX_MESSAGES) {
            messages.removeFirst();
        }
        messages.addLast(new TextMessage(severity, text, clock.instant(), about));
        messageSnapshot = List.copyOf(messages);
    }

    private void publish() {
        version++;
        state = snapshot();
    }

    /** What was measured before a silence says nothing about the link after it. */
    private LinkStatus link() {
        boolean lost = linkState == LinkState.LOST;
        return new LinkStatus(
                key,
                transport,
                linkState,
                lastHeard,
                lost ? LinkQuality.UNKNOWN : quality,
                lost ? LinkTrend.UNKNOWN : trend,
                otherKeys,
                ages.outdated());
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
                messageSnapshot,
                clock.instant(),
                version,
                ground.amslMeters());
    }
}

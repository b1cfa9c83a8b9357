package org.dronemap.ws.drone;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import org.dronemap.core.access.Principal;
import org.dronemap.core.cloud.ControlGate;
import org.dronemap.core.cloud.rule.CommandRules;
import org.dronemap.core.cloud.rule.RoleRules;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.Capabilities.Steering;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.CloudLossAction;
import org.dronemap.core.drone.CloudLossState;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.GpsFix;
import org.dronemap.core.drone.IdentityEvidence;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkStatus;
import org.dronemap.core.drone.LocalPosition;
import org.dronemap.core.drone.MissionPhase;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.Position;
import org.dronemap.core.drone.SensorSnapshot;
import org.dronemap.ws.mission.MissionItemView;
import org.dronemap.ws.reading.WireNames;
import org.jspecify.annotations.Nullable;

/** Maps a drone's state to what clients see, once for all faces. Any thread. */
public final class DroneViewMapper {
    private static final String FORCE_DISARM = "forceDisarm";

    private final DronePlaceNames places;
    private final ControlGate controls;
    private final Function<DroneId, SensorSnapshot> sensed;
    private final Function<DroneId, CloudLossState> losses;

    /**
     * {@code controls} knows who commands a drone now, {@code sensed} what its sensors brought last, {@code losses} what it does
     * without the cloud.
     */
    public DroneViewMapper(
            DronePlaceNames places,
            ControlGate controls,
            Function<DroneId, SensorSnapshot> sensed,
            Function<DroneId, CloudLossState> losses) {
        this.losses = losses;
        this.sensed = sensed;
        this.places = places;
        this.controls = controls;
    }

    public DroneView view(DroneState state, Principal principal) {
        return new DroneView(
                state.id().value(),
                state.name(),
                state.replay(),
                link(state.link()),
                identity(state),
                WireNames.camel(state.identification().kind()),
                state.identification().autopilot(),
                state.identification().vehicle(),
                state.identification().firmware(),
                state.mode(),
                state.capabilities().modes(),
                state.armed(),
                state.readyToArm(),
                state.phase() == null ? null : WireNames.camel(state.phase()),
                position(state.position()),
                local(state.local()),
                numbers(sensed.apply(state.id())),
                places.place(state),
                motion(state),
                attitude(state),
                battery(state),
                gps(state),
                home(state),
                loss(losses.apply(state.id())),
                mission(state),
                messages(state),
                actions(state, principal),
                ControlView.of(controls.control(state.id())),
                controls.outlook(state.id()).map(OutlookView::of).orElse(null),
                millis(state.lastUpdate()),
                state.version());
    }

    private static DroneView.CloudLossView loss(CloudLossState loss) {
        CloudLossAction action = loss.action();
        return new DroneView.CloudLossView(
                WireNames.camel(loss.state()),
                action == null ? null : action.action(),
                action == null ? null : action.afterSeconds(),
                loss.returnMeters(),
                loss.sentence(),
                loss.outstanding().stream()
                        .map(value -> new DroneView.OutstandingView(value.name(), value.owners(), value.ours()))
                        .toList());
    }

    private static DroneView.LinkView link(LinkStatus link) {
        Instant heard = link.lastHeard();
        return new DroneView.LinkView(
                link.key().address(),
                link.key().port(),
                link.key().systemId(),
                link.transport(),
                WireNames.camel(link.state()),
                heard == null ? null : millis(heard),
                quality(link.quality()),
                new DroneView.TrendView(
                        WireNames.camel(link.trend().state()),
                        link.trend().secondsLeft(),
                        link.trend().words()),
                link.others().stream().map(DroneKey::toString).toList(),
                link.outdated().stream()
                        .map(old -> new DroneView.OutdatedView(WireNames.camel(old.part()), millis(old.lastHeard())))
                        .toList());
    }

    private static DroneView.IdentityView identity(DroneState state) {
        IdentityEvidence strongest = state.standing().strongest();
        return new DroneView.IdentityView(
                WireNames.camel(strongest),
                strongest.isProof(),
                state.identification().hardwareUid());
    }

    private static DroneView.QualityView quality(LinkQuality quality) {
        return new DroneView.QualityView(
                rounded(quality.lossShort(), 10_000),
                rounded(quality.lossLong(), 10_000),
                rounded(quality.roundTripMillis(), 100),
                rounded(quality.roundTripLongMillis(), 100),
                rounded(quality.jitterMillis(), 100),
                rounded(quality.jitterLongMillis(), 100));
    }

    private static @Nullable Double rounded(@Nullable Double value, int parts) {
        return value == null ? null : (Double) ((double) Math.round(value * parts) / parts);
    }

    public static DroneView.@Nullable PositionView position(@Nullable Position position) {
        if (position == null) {
            return null;
        }
        var point = position.point();
        return new DroneView.PositionView(
                point == null ? null : point.latitudeDegrees(),
                point == null ? null : point.longitudeDegrees(),
                position.altitudeAmslMeters(),
                position.altitudeAboveHomeMeters());
    }

    private static DroneView.@Nullable LocalView local(@Nullable LocalPosition local) {
        return local == null
                ? null
                : new DroneView.LocalView(local.xMeters(), local.yMeters(), local.zMeters(), local.yawDegrees());
    }

    private static DroneView.@Nullable SensedNumbersView numbers(SensorSnapshot sensed) {
        return sensed.equals(SensorSnapshot.NOTHING)
                ? null
                : new DroneView.SensedNumbersView(
                        number(sensed.scan()), number(sensed.picture()), number(sensed.map()));
    }

    private static @Nullable Long number(SensorSnapshot.@Nullable Sample<?> kept) {
        return kept == null ? null : (Long) kept.number();
    }

    public static DroneView.@Nullable MotionView motion(DroneState state) {
        var motion = state.motion();
        return motion == null
                ? null
                : new DroneView.MotionView(
                        motion.groundSpeed(), motion.airSpeed(), motion.climbRate(), motion.headingDegrees());
    }

    private static DroneView.@Nullable AttitudeView attitude(DroneState state) {
        var attitude = state.attitude();
        return attitude == null
                ? null
                : new DroneView.AttitudeView(attitude.rollDegrees(), attitude.pitchDegrees(), attitude.yawDegrees());
    }

    private static DroneView.@Nullable BatteryView battery(DroneState state) {
        var battery = state.battery();
        return battery == null
                ? null
                : new DroneView.BatteryView(
                        battery.percent(),
                        battery.volts(),
                        battery.amps(),
                        battery.further().stream()
                                .map(other -> new DroneView.FurtherBatteryView(
                                        other.number(), other.percent(), other.volts(), other.amps()))
                                .toList());
    }

    private static DroneView.@Nullable GpsView gps(DroneState state) {
        var gps = state.gps();
        if (gps == null) {
            return null;
        }
        GpsFix fix = gps.fix();
        return new DroneView.GpsView(fix.label(), gps.satellites(), gps.hdop());
    }

    private static DroneView.@Nullable HomeView home(DroneState state) {
        var home = state.home();
        return home == null
                ? null
                : new DroneView.HomeView(
                        home.point().latitudeDegrees(), home.point().longitudeDegrees(), home.altitudeAmslMeters());
    }

    private static DroneView.MissionView mission(DroneState state) {
        MissionProgress mission = state.mission();
        var items = mission.items();
        boolean inMode = state.capabilities().steering(state.mode()).equals(Optional.of(Steering.MISSION));
        MissionPhase phase = mission.phase();
        boolean running = Boolean.TRUE.equals(state.armed())
                && !mission.complete()
                && (phase == null ? inMode : phase == MissionPhase.RUNNING);
        return new DroneView.MissionView(
                items == null ? null : MissionItemView.of(items),
                mission.current(),
                mission.reached(),
                items == null ? null : items.size(),
                running,
                phase == null ? null : WireNames.camel(phase),
                mission.notice(),
                mission.hash());
    }

    private static List<DroneView.MessageView> messages(DroneState state) {
        return state.messages().stream()
                .map(message -> new DroneView.MessageView(
                        WireNames.camel(message.severity()), message.text(), millis(message.at())))
                .toList();
    }

    /** For every kind of command: whether the asker may give it now, with the gate's own sentence when not. */
    private static Map<String, DroneView.ActionView> actions(DroneState state, Principal principal) {
        Map<String, DroneView.ActionView> actions = new LinkedHashMap<>();
        for (Capability capability : Capability.values()) {
            Optional<Refusal> why =
                    RoleRules.whyNot(principal, state, capability).or(() -> CommandRules.whyNot(state, capability));
            String mode = capability == Capability.ARM
                    ? state.capabilities().armingMode(state.mode()).orElse(null)
                    : null;
            actions.put(
                    WireNames.camel(capability),
                    why.map(refusal -> DroneView.ActionView.forbidden(refusal, mode))
                            .orElseGet(() -> DroneView.ActionView.allowedIn(mode)));
        }
        Command motorsOff = new Command.Disarm(true);
        Optional<Refusal> why =
                RoleRules.whyNot(principal, state, motorsOff.needs()).or(() -> CommandRules.whyNot(state, motorsOff));
        actions.put(
                FORCE_DISARM,
                why.map(refusal -> DroneView.ActionView.forbidden(refusal, null))
                        .orElseGet(() -> DroneView.ActionView.allowedIn(null)));
        return actions;
    }

    private static Instant millis(Instant instant) {
        return instant.truncatedTo(ChronoUnit.MILLIS);
    }
}

package org.dronemap.ws.drone;

import com.fasterxml.jackson.annotation.JsonInclude;
import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.CloudLossState;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.drone.IdentityEvidence;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LinkTrend;
import org.dronemap.core.drone.MissionPhase;
import org.dronemap.core.drone.Severity;
import org.dronemap.core.drone.StatePart;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.ws.mission.MissionItemView;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.reading.EnumValues;
import org.jspecify.annotations.Nullable;

/** A drone as clients see it; a fact that nobody knows is null. */
@Schema(name = "DroneView", description = "A drone now. A fact that nobody knows is null, never 0.")
public record DroneView(
        String id,
        String name,
        boolean replay,
        LinkView link,
        IdentityView identity,
        @EnumValues(VehicleKind.class) String kind,
        String autopilot,
        String vehicle,
        @Nullable String firmware,
        @Nullable String mode,
        List<String> modes,
        @Nullable Boolean armed,
        @Nullable Boolean readyToArm,
        @EnumValues(FlightPhase.class) @Nullable String flight,
        @Nullable PositionView position,
        @Nullable LocalView local,

        @Schema(description = "The numbers of the newest that its sensors brought; null while there was nothing")
        @Nullable
        SensedNumbersView sensed,

        @Nullable String place,
        @Nullable MotionView motion,
        @Nullable AttitudeView attitude,
        @Nullable BatteryView battery,
        @Nullable GpsView gps,
        @Nullable HomeView home,
        CloudLossView cloudLoss,
        MissionView mission,
        List<MessageView> messages,

        @Schema(
                description =
                        "Every kind of command, and forceDisarm: the motors off even in the air (disarm with force)")
        Map<String, ActionView> actions,

        ControlView control,

        @Schema(description = "What becomes of it when whoever has it has it no more; null: it is not in the air")
        @Nullable
        OutlookView outlook,

        Instant lastUpdate,
        long version) {

    /** The link that it is reached by. */
    @Schema(name = "DroneLinkView")
    public record LinkView(
            String address,
            int port,
            int systemId,
            String transport,
            @EnumValues(LinkState.class) String state,
            @Nullable Instant lastHeard,
            QualityView quality,

            @Schema(description = "Null: the server is older than this, and does not tell it") @Nullable
            TrendView trend,

            @Schema(description = "Further addresses on which the same vehicle is heard")
            List<String> others,

            @Schema(
                    description = "Parts of the state that the vehicle has stopped telling though it is heard: their"
                            + " values are old. Empty while it is lost, when all is old")
            List<OutdatedView> outdated) {}

    /** A part of a drone's state that is told no more, and when it last was. */
    @Schema(name = "DroneOutdatedView")
    public record OutdatedView(@EnumValues(StatePart.class) String part, Instant lastHeard) {}

    /** Evidence of a drone's identity: address, hardware, signature or link; only the last two prove it. */
    @Schema(name = "DroneIdentityView")
    public record IdentityView(
            @EnumValues(IdentityEvidence.class) String evidence,
            boolean proved,
            @Nullable String hardwareId) {}

    /** The trend of a link's quality, compared with how it usually is; falling: it is expected to be lost soon. */
    @Schema(name = "DroneLinkTrendView")
    public record TrendView(
            @EnumValues(LinkTrend.State.class) String state,

            @Schema(description = "About so long until it is lost, if it goes on so; null where it gets no worse")
            @Nullable
            Integer secondsLeft,

            @Schema(description = "What is seen, as a sentence")
            String sentence) {}

    /**
     * Over some 5 s and 60 s: shares from 0 to 1 of the vehicle's messages that were lost, milliseconds there and back, and
     * by how many milliseconds messages come sooner or later than those before them.
     */
    @Schema(name = "DroneQualityView")
    public record QualityView(
            @Nullable Double lossShort,
            @Nullable Double lossLong,
            @Nullable Double rttMs,
            @Nullable Double rttLongMs,
            @Nullable Double jitterMs,
            @Nullable Double jitterLongMs) {}

    /** Degrees, and metres above sea level and above home. */
    @Schema(name = "DronePositionView")
    public record PositionView(
            @Nullable Double latitude,
            @Nullable Double longitude,
            @Nullable Double altitudeAmsl,
            @Nullable Double altitudeAboveHome) {}

    /** Metres in a frame of its own, such as its map; yaw in degrees counter-clockwise from x. */
    @Schema(name = "DroneLocalView")
    public record LocalView(
            double x,
            double y,
            @Nullable Double z,
            @Nullable Double yaw) {}

    /** Each kind counted by itself; null where there was none yet. */
    @Schema(name = "DroneSensedNumbersView")
    public record SensedNumbersView(
            @Nullable Long scan,
            @Nullable Long picture,
            @Nullable Long map) {}

    /** Metres a second; heading in degrees. */
    @Schema(name = "DroneMotionView")
    public record MotionView(
            @Nullable Double groundSpeed,
            @Nullable Double airSpeed,
            @Nullable Double climbRate,
            @Nullable Double heading) {}

    /** Degrees. */
    @Schema(name = "DroneAttitudeView")
    public record AttitudeView(double roll, double pitch, double yaw) {}

    /** Per cent, volts, amperes. */
    @Schema(name = "DroneBatteryView")
    public record BatteryView(
            @Nullable Integer percent,
            @Nullable Double volts,
            @Nullable Double amps,

            @Schema(description = "Batteries beside the main one")
            List<FurtherBatteryView> further) {}

    /** A battery beside the main one, by the vehicle's number for it. */
    @Schema(name = "DroneFurtherBatteryView")
    public record FurtherBatteryView(
            int number,
            @Nullable Integer percent,
            @Nullable Double volts,
            @Nullable Double amps) {}

    /** Satellite reception. */
    @Schema(name = "DroneGpsView")
    public record GpsView(
            @Schema(allowableValues = {"none", "2D", "3D", "DGPS", "RTK float", "RTK fixed"})
            String fix,

            @Nullable Integer satellites,
            @Nullable Double hdop) {}

    /** Home position that the drone returns to; degrees and metres above sea level. */
    @Schema(name = "DroneHomeView")
    public record HomeView(double latitude, double longitude, double altitudeAmsl) {}

    /**
     * Action of a drone by itself when it has lost contact with the cloud. {@code state} is set, notSet or cannotBeSet;
     * {@code sentence} says it for people; {@code returnHeight} is metres above home, where the cloud chose it.
     */
    @Schema(name = "DroneCloudLossView")
    public record CloudLossView(
            @EnumValues(CloudLossState.State.class) String state,
            @Nullable String action,
            @Nullable Double afterSeconds,

            @Schema(description = "Metres above home") @Nullable
            Double returnHeight,

            String sentence,

            @Schema(description = "What its owner had set, and is put back once nobody uses it")
            List<OutstandingView> outstanding) {}

    /** A parameter that the cloud has changed, with what its owner had set. */
    @Schema(name = "DroneOutstandingView")
    public record OutstandingView(String name, double owners, double now) {}

    /**
     * The mission that is on the vehicle; indices are into the items. {@code state} is stopped, running, paused or
     * complete; null when the vehicle does not say. {@code hash} stands for all that the vehicle keeps of the mission,
     * finer settings included: equal hashes, equal missions.
     */
    @Schema(name = "DroneMissionView")
    public record MissionView(
            @Nullable List<MissionItemView> items,
            @Nullable Integer current,
            List<Integer> reached,
            @Nullable Integer total,
            boolean running,
            @EnumValues(MissionPhase.class) @Nullable String state,
            @Nullable String notice,
            @Nullable String hash) {}

    /** A sentence of the vehicle or about it. */
    @Schema(name = "DroneMessageView")
    public record MessageView(@EnumValues(Severity.class) String severity, String text, Instant at) {}

    /** Availability of a command now, with the reason when it cannot be given. */
    @Schema(name = "DroneActionView")
    public record ActionView(
            boolean allowed,
            @Nullable String why,

            @Schema(description = "Why not, for programs; docs/problems.md lists them; left out when it is allowed")
            @JsonInclude(JsonInclude.Include.NON_NULL)
            @Nullable
            String code,

            @Schema(description = "The vehicle refuses it in its mode of now: change to this one first") @Nullable
            String mode) {

        public static ActionView allowedIn(@Nullable String mode) {
            return new ActionView(true, null, null, mode);
        }

        public static ActionView forbidden(Rejection why) {
            return new ActionView(false, why.sentence(), why.code().word(), null);
        }

        public static ActionView forbidden(Refusal why, @Nullable String mode) {
            return new ActionView(false, why.sentence(), why.code().word(), mode);
        }
    }
}

package org.dronemap.core.command;

import java.util.Optional;
import java.util.stream.Stream;
import org.dronemap.core.drone.Capability;

/**
 * Kinds of commands, each with the capability it needs, its purpose, its effects and what it competes with. Vehicles
 * alone have one: they cannot do what they do not say that they can.
 */
public enum CommandKind {
    ARM("Arm", Capability.ARM, Contention.ARMING, Purpose.FLY, ImmediateEffect.NONE, DeferredEffect.NOTHING),
    DISARM(
            "Disarm",
            Capability.DISARM,
            Contention.ARMING,
            Purpose.CHANGE,
            ImmediateEffect.NONE,
            DeferredEffect.NOTHING),
    SET_MODE(
            "SetMode",
            Capability.SET_MODE,
            Contention.FLIGHT,
            Purpose.FLY,
            ImmediateEffect.CHANGES_MODE,
            DeferredEffect.MODE),
    TAKE_OFF(
            "TakeOff",
            Capability.TAKE_OFF,
            Contention.FLIGHT,
            Purpose.FLY,
            ImmediateEffect.CLIMBS,
            DeferredEffect.NOTHING),
    LAND(
            "Land",
            Capability.LAND,
            Contention.FLIGHT,
            Purpose.SAFETY,
            ImmediateEffect.COMES_DOWN,
            DeferredEffect.NOTHING),
    RETURN_TO_LAUNCH(
            "ReturnToLaunch",
            Capability.RETURN_TO_LAUNCH,
            Contention.FLIGHT,
            Purpose.SAFETY,
            ImmediateEffect.COMES_DOWN,
            DeferredEffect.NOTHING),
    HOLD("Hold", Capability.HOLD, Contention.FLIGHT, Purpose.SAFETY, ImmediateEffect.STANDS, DeferredEffect.NOTHING),
    EMERGENCY_STOP(
            "EmergencyStop",
            Capability.EMERGENCY_STOP,
            Contention.FLIGHT,
            Purpose.SAFETY,
            ImmediateEffect.STANDS,
            DeferredEffect.NOTHING),
    GO_TO("GoTo", Capability.GO_TO, Contention.FLIGHT, Purpose.FLY, ImmediateEffect.GOES, DeferredEffect.NOTHING),
    GO_TO_LOCAL(
            "GoToLocal",
            Capability.GO_TO_LOCAL,
            Contention.FLIGHT,
            Purpose.FLY,
            ImmediateEffect.GOES_ON_ITS_MAP,
            DeferredEffect.NOTHING),
    TURN("Turn", Capability.TURN, Contention.FLIGHT, Purpose.FLY, ImmediateEffect.TURNS, DeferredEffect.NOTHING),
    CHANGE_SPEED(
            "ChangeSpeed",
            Capability.CHANGE_SPEED,
            Contention.SPEED,
            Purpose.FLY,
            ImmediateEffect.CHANGES_SPEED,
            DeferredEffect.NOTHING),
    UPLOAD_MISSION(
            "UploadMission",
            Capability.UPLOAD_MISSION,
            Contention.TRANSFER,
            Purpose.CHANGE,
            ImmediateEffect.TAKES_MISSION,
            DeferredEffect.NOTHING),
    START_MISSION(
            "StartMission",
            Capability.START_MISSION,
            Contention.FLIGHT,
            Purpose.FLY,
            ImmediateEffect.FLIES_MISSION,
            DeferredEffect.NOTHING),
    PAUSE_MISSION(
            "PauseMission",
            Capability.PAUSE_MISSION,
            Contention.FLIGHT,
            Purpose.PAUSE,
            ImmediateEffect.STANDS,
            DeferredEffect.NOTHING),
    CLEAR_MISSION(
            "ClearMission",
            Capability.CLEAR_MISSION,
            Contention.TRANSFER,
            Purpose.CHANGE,
            ImmediateEffect.STANDS,
            DeferredEffect.NOTHING),
    SET_HOME(
            "SetHome", Capability.SET_HOME, Contention.HOME, Purpose.CHANGE, ImmediateEffect.NONE, DeferredEffect.HOME),
    READ_HOME(
            "ReadHome",
            Capability.READ_HOME,
            Contention.HOME,
            Purpose.READ,
            ImmediateEffect.NONE,
            DeferredEffect.NOTHING),
    TAKE_PICTURE(
            "TakePicture",
            Capability.TAKE_PICTURE,
            Contention.CAMERA,
            Purpose.CHANGE,
            ImmediateEffect.NONE,
            DeferredEffect.NOTHING),
    SET_RELAY(
            "SetRelay",
            Capability.SET_RELAY,
            Contention.RELAY,
            Purpose.CHANGE,
            ImmediateEffect.NONE,
            DeferredEffect.NOTHING),
    READ_PARAMETERS(
            "ReadParameters",
            Capability.READ_PARAMETERS,
            Contention.PARAMETERS,
            Purpose.READ,
            ImmediateEffect.NONE,
            DeferredEffect.NOTHING),
    SET_PARAMETERS(
            "SetParameters",
            Capability.SET_PARAMETERS,
            Contention.PARAMETERS,
            Purpose.CHANGE,
            ImmediateEffect.NONE,
            DeferredEffect.PARAMETERS),
    SET_RETURN_HEIGHT(
            "SetReturnHeight",
            Capability.SET_PARAMETERS,
            Contention.PARAMETERS,
            Purpose.CHANGE,
            ImmediateEffect.NONE,
            DeferredEffect.PARAMETERS),
    RETURN_ON_LOSS(
            "ReturnOnLoss",
            Capability.SET_PARAMETERS,
            Contention.PARAMETERS,
            Purpose.CHANGE,
            ImmediateEffect.NONE,
            DeferredEffect.NOTHING),
    SET_CLOUD_LOSS(
            "SetCloudLoss",
            Capability.SET_PARAMETERS,
            Contention.PARAMETERS,
            Purpose.CHANGE,
            ImmediateEffect.NONE,
            DeferredEffect.NOTHING),
    PUT_BACK(
            "PutBack",
            Capability.SET_PARAMETERS,
            Contention.PARAMETERS,
            Purpose.CHANGE,
            ImmediateEffect.NONE,
            DeferredEffect.NOTHING),
    READ_LOGS(
            "ReadLogs",
            Capability.READ_LOGS,
            Contention.LOGS,
            Purpose.READ,
            ImmediateEffect.NONE,
            DeferredEffect.NOTHING),
    DOWNLOAD_LOG(
            "DownloadLog",
            Capability.READ_LOGS,
            Contention.LOGS,
            Purpose.READ,
            ImmediateEffect.NONE,
            DeferredEffect.NOTHING),
    READ_FENCE(
            "ReadFence",
            Capability.FENCE,
            Contention.TRANSFER,
            Purpose.READ,
            ImmediateEffect.NONE,
            DeferredEffect.NOTHING),
    SET_FENCE(
            "SetFence",
            Capability.FENCE,
            Contention.TRANSFER,
            Purpose.CHANGE,
            ImmediateEffect.STANDS,
            DeferredEffect.NOTHING),
    READ_RALLY_POINTS(
            "ReadRallyPoints",
            Capability.RALLY_POINTS,
            Contention.TRANSFER,
            Purpose.READ,
            ImmediateEffect.NONE,
            DeferredEffect.NOTHING),
    SET_RALLY_POINTS(
            "SetRallyPoints",
            Capability.RALLY_POINTS,
            Contention.TRANSFER,
            Purpose.CHANGE,
            ImmediateEffect.STANDS,
            DeferredEffect.RALLY_POINTS),
    READ_MAP(
            "ReadMap", Capability.READ_MAP, Contention.MAP, Purpose.READ, ImmediateEffect.NONE, DeferredEffect.NOTHING);

    /** Purpose of a command, which decides who may give it without control and who pays for it. */
    public enum Purpose {
        /** Asks the vehicle and changes nothing: needs no control of it. */
        READ,
        /** Brings it to safety: works for supervisors without control, for nothing, and even when nothing can be written. */
        SAFETY,
        /** Stops what it is at: works for supervisors without control, and for nothing. */
        PAUSE,
        /** Sends it somewhere, or readies it for that: who gives one is who flies it. */
        FLY,
        /** Changes what it has, or what it carries. */
        CHANGE;

        /** Nobody is kept waiting with it, whoever has control. */
        public boolean interrupts() {
            return this == SAFETY || this == PAUSE;
        }
    }

    private final String word;
    private final Capability needs;
    private final Contention contention;
    private final Purpose purpose;
    private final ImmediateEffect movement;
    private final DeferredEffect laterChange;

    CommandKind(
            String word,
            Capability needs,
            Contention contention,
            Purpose purpose,
            ImmediateEffect movement,
            DeferredEffect laterChange) {
        this.word = word;
        this.needs = needs;
        this.contention = contention;
        this.purpose = purpose;
        this.movement = movement;
        this.laterChange = laterChange;
    }

    /** The kind with that word; empty when there is none (any more). */
    public static Optional<CommandKind> named(String word) {
        return Stream.of(values()).filter(kind -> kind.word.equals(word)).findFirst();
    }

    /** For ever: stored with every command. */
    public String word() {
        return word;
    }

    /** What the vehicle must be able to do for it. */
    public Capability needs() {
        return needs;
    }

    public Contention contention() {
        return contention;
    }

    public Purpose purpose() {
        return purpose;
    }

    public ImmediateEffect movement() {
        return movement;
    }

    public DeferredEffect laterChange() {
        return laterChange;
    }
}

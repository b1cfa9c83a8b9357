package org.dronemap.core.command;

import java.util.Optional;
import java.util.stream.Stream;
import org.dronemap.core.drone.Capability;

/**
 * What there is of commands, with what each means to everybody who judges one. Whoever handles commands switches over these
 * without a default, so that one that is forgotten anywhere does not compile.
 */
public enum CommandKind {
    ARM("Arm", Capability.ARM, Contention.ARMING, Purpose.FLY),
    DISARM("Disarm", Capability.DISARM, Contention.ARMING, Purpose.CHANGE),
    SET_MODE("SetMode", Capability.SET_MODE, Contention.FLIGHT, Purpose.FLY),
    TAKE_OFF("TakeOff", Capability.TAKE_OFF, Contention.FLIGHT, Purpose.FLY),
    LAND("Land", Capability.LAND, Contention.FLIGHT, Purpose.SAFETY),
    RETURN_TO_LAUNCH("ReturnToLaunch", Capability.RETURN_TO_LAUNCH, Contention.FLIGHT, Purpose.SAFETY),
    HOLD("Hold", Capability.HOLD, Contention.FLIGHT, Purpose.SAFETY),
    EMERGENCY_STOP("EmergencyStop", Capability.EMERGENCY_STOP, Contention.FLIGHT, Purpose.SAFETY),
    GO_TO("GoTo", Capability.GO_TO, Contention.FLIGHT, Purpose.FLY),
    GO_TO_LOCAL("GoToLocal", Capability.GO_TO_LOCAL, Contention.FLIGHT, Purpose.FLY),
    TURN("Turn", Capability.TURN, Contention.FLIGHT, Purpose.FLY),
    UPLOAD_MISSION("UploadMission", Capability.UPLOAD_MISSION, Contention.TRANSFER, Purpose.CHANGE),
    START_MISSION("StartMission", Capability.START_MISSION, Contention.FLIGHT, Purpose.FLY),
    PAUSE_MISSION("PauseMission", Capability.PAUSE_MISSION, Contention.FLIGHT, Purpose.PAUSE),
    CLEAR_MISSION("ClearMission", Capability.CLEAR_MISSION, Contention.TRANSFER, Purpose.CHANGE),
    SET_HOME("SetHome", Capability.SET_HOME, Contention.HOME, Purpose.CHANGE),
    READ_HOME("ReadHome", Capability.READ_HOME, Contention.HOME, Purpose.READ),
    TAKE_PICTURE("TakePicture", Capability.TAKE_PICTURE, Contention.CAMERA, Purpose.CHANGE),
    SET_RELAY("SetRelay", Capability.SET_RELAY, Contention.RELAY, Purpose.CHANGE),
    READ_PARAMETERS("ReadParameters", Capability.READ_PARAMETERS, Contention.PARAMETERS, Purpose.READ),
    SET_PARAMETERS("SetParameters", Capability.SET_PARAMETERS, Contention.PARAMETERS, Purpose.CHANGE),
    SET_RETURN_HEIGHT("SetReturnHeight", Capability.SET_PARAMETERS, Contention.PARAMETERS, Purpose.CHANGE),
    RETURN_ON_LOSS("ReturnOnLoss", Capability.SET_PARAMETERS, Contention.PARAMETERS, Purpose.CHANGE),
    SET_CLOUD_LOSS("SetCloudLoss", Capability.SET_PARAMETERS, Contention.PARAMETERS, Purpose.CHANGE),
    PUT_BACK("PutBack", Capability.SET_PARAMETERS, Contention.PARAMETERS, Purpose.CHANGE),
    READ_LOGS("ReadLogs", Capability.READ_LOGS, Contention.LOGS, Purpose.READ),
    DOWNLOAD_LOG("DownloadLog", Capability.READ_LOGS, Contention.LOGS, Purpose.READ),
    READ_FENCE("ReadFence", Capability.FENCE, Contention.TRANSFER, Purpose.READ),
    SET_FENCE("SetFence", Capability.FENCE, Contention.TRANSFER, Purpose.CHANGE),
    READ_RALLY_POINTS("ReadRallyPoints", Capability.RALLY_POINTS, Contention.TRANSFER, Purpose.READ),
    SET_RALLY_POINTS("SetRallyPoints", Capability.RALLY_POINTS, Contention.TRANSFER, Purpose.CHANGE),
    READ_MAP("ReadMap", Capability.READ_MAP, Contention.MAP, Purpose.READ);

    /** What a command is for, which decides who may give it without control and who pays for it. */
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

    CommandKind(String word, Capability needs, Contention contention, Purpose purpose) {
        this.word = word;
        this.needs = needs;
        this.contention = contention;
        this.purpose = purpose;
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
}

package org.dronemap.mavlink.generator;

import io.dronefleet.mavlink.annotations.MavlinkMessageInfo;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;

/**
 * Writes the message records and the table of checksum seeds from dronefleet's definitions. Run it after adding a name
 * to the list below, from the module's folder, and format: see docs/how-to-add/message.md.
 */
public final class MessageGenerator {
    static final List<String> MESSAGES = List.of(
            "Attitude",
            "AutopilotVersion",
            "BatteryStatus",
            "CameraFeedback",
            "CameraImageCaptured",
            "CommandAck",
            "CommandCancel",
            "CommandInt",
            "CommandLong",
            "ExtendedSysState",
            "FileTransferProtocol",
            "GimbalDeviceAttitudeStatus",
            "GimbalManagerSetPitchyaw",
            "GlobalPositionInt",
            "GpsRawInt",
            "Heartbeat",
            "HomePosition",
            "LogData",
            "LogEntry",
            "LogRequestData",
            "LogRequestEnd",
            "LogRequestList",
            "ManualControl",
            "MissionAck",
            "MissionClearAll",
            "MissionCount",
            "MissionCurrent",
            "MissionItem",
            "MissionItemInt",
            "MissionItemReached",
            "MissionRequest",
            "MissionRequestInt",
            "MissionRequestList",
            "MissionSetCurrent",
            "MissionWritePartialList",
            "NamedValueFloat",
            "ParamRequestList",
            "ParamRequestRead",
            "ParamSet",
            "ParamValue",
            "Ping",
            "PositionTargetGlobalInt",
            "RadioStatus",
            "RcChannelsOverride",
            "RequestDataStream",
            "ServoOutputRaw",
            "SetMode",
            "SetPositionTargetGlobalInt",
            "SetPositionTargetLocalNed",
            "SetupSigning",
            "Statustext",
            "SysStatus",
            "SystemTime",
            "Timesync",
            "VfrHud",
            "Wind",
            "WindCov");

    private MessageGenerator() {}

    public static void main(String[] arguments) throws IOException {
        Map<Integer, Class<?>> definitions = Definitions.all();
        Path sources = Path.of("src/main/java/org/dronemap/mavlink/message");
        Files.createDirectories(sources);
        for (Class<?> type : definitions.values()) {
            if (MESSAGES.contains(type.getSimpleName())) {
                Files.writeString(sources.resolve(type.getSimpleName() + ".java"), MessageSources.source(type));
            }
        }
        Files.writeString(Path.of("src/main/resources/org/dronemap/mavlink/messages.tsv"), table(definitions));
    }

    static String table(Map<Integer, Class<?>> definitions) {
        StringBuilder table = new StringBuilder(
                "# id\tname\tchecksum seed\tshortest payload\tlongest payload" + "\toffset of target system\n");
        definitions.forEach((id, type) -> table.append(id)
                .append('\t')
                .append(type.getSimpleName())
                .append('\t')
                .append(type.getAnnotation(MavlinkMessageInfo.class).crc())
                .append('\t')
                .append(MessageSources.lengthWithoutExtensions(type))
                .append('\t')
                .append(MessageSources.length(type))
                .append('\t')
                .append(MessageSources.targetSystemOffset(type))
                .append('\n'));
        return table.toString();
    }
}

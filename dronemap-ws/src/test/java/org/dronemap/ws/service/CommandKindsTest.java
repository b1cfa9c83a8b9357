package org.dronemap.ws.service;

import static org.assertj.core.api.Assertions.assertThat;

import jakarta.jws.WebParam;
import java.io.IOException;
import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.core.command.Command;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LinkStatus;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.Payload;
import org.dronemap.core.drone.Standing;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.parameter.ParameterSet;
import org.dronemap.ws.soap.MAVLinkController;
import org.dronemap.ws.soap.SoapOutcome;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Each way in knows each kind of command, mission item and outcome, or says here why it does not. */
class CommandKindsTest {
    private static final Path PAGE = Path.of("../web-client/src/api");
    private static final DroneState UNKNOWN = new DroneState(
            new DroneId("d-1"),
            "d-1",
            false,
            new LinkStatus(
                    new DroneKey("127.0.0.1", 14_550, 1),
                    "udp",
                    LinkState.LIVE,
                    Instant.EPOCH,
                    LinkQuality.UNKNOWN,
                    List.of()),
            new Identification(VehicleKind.MULTICOPTER, "ArduPilot", "ArduCopter", null, null),
            Standing.UNPROVED,
            Capabilities.UNKNOWN,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            null,
            Payload.UNKNOWN,
            MissionProgress.UNKNOWN,
            List.of(),
            Instant.EPOCH,
            1,
            null);
    private static final Path DESCRIPTION = Path.of("src", "test", "resources", "wire", "openapi.json");
    private static final Set<String> TYPES = Set.of(CommandRequest.TYPES.split(", "));

    /** The operation of SOAP that gives it; empty where clients of SOAP are not to. */
    private static Optional<String> soap(CommandKind kind) {
        return switch (kind) {
            case ARM -> Optional.of("arm");
            case DISARM -> Optional.of("disarm");
            case SET_MODE -> Optional.of("setMode");
            case TAKE_OFF -> Optional.of("takeoff");
            case LAND -> Optional.of("land");
            case RETURN_TO_LAUNCH -> Optional.of("returnToLaunch");
            case HOLD -> Optional.of("hold");
            case EMERGENCY_STOP -> Optional.of("emergencyStop");
            case GO_TO -> Optional.of("goTo");
            case GO_TO_LOCAL -> Optional.of("goToLocal");
            case TURN -> Optional.of("turn");
            case UPLOAD_MISSION -> Optional.of("uploadMission");
            case START_MISSION -> Optional.of("startMission");
            case PAUSE_MISSION -> Optional.of("pauseMission");
            case CLEAR_MISSION -> Optional.of("clearMission");
            case SET_HOME -> Optional.of("setHome");
            case TAKE_PICTURE -> Optional.of("takePicture");
            case SET_RELAY -> Optional.of("setRelay");
            case READ_PARAMETERS -> Optional.of("readParameters");
            case SET_PARAMETERS -> Optional.of("setParameter");
            case READ_MAP -> Optional.of("readMap");
            // Clients of SOAP read homes with the drone; logs, fences and rally points are for people at the page.
            case READ_HOME, READ_LOGS, DOWNLOAD_LOG, READ_FENCE, SET_FENCE, READ_RALLY_POINTS, SET_RALLY_POINTS ->
                Optional.empty();
            // Given by the cloud alone.
            case SET_RETURN_HEIGHT, RETURN_ON_LOSS, SET_CLOUD_LOSS, PUT_BACK -> Optional.empty();
        };
    }

    @Test
    void hasAnOperationOfSoapForEachKindAndNoneBeside() {
        Set<String> giving = Stream.of(MAVLinkController.class.getMethods())
                .filter(method -> method.getReturnType() == SoapOutcome.class && isOfADrone(method))
                .map(Method::getName)
                .collect(Collectors.toSet());

        assertThat(Stream.of(CommandKind.values()).flatMap(kind -> soap(kind).stream()))
                .containsExactlyInAnyOrderElementsOf(giving);
    }

    private static boolean isOfADrone(Method method) {
        return Arrays.stream(method.getParameters())
                .findFirst()
                .filter(first -> first.getAnnotation(WebParam.class).name().equals(MAVLinkController.DRONE))
                .isPresent();
    }

    @ParameterizedTest
    @EnumSource
    void readsWhatItTellsClientsThatThereIs(CommandKind kind) {
        String type = WireNames.lowerFirst(kind.word());
        ParameterSet held = ParameterSet.of(List.of(), Instant.EPOCH);
        String wrong = "";
        Optional<Command> read = Optional.empty();
        try {
            read = Optional.of(CommandReader.asked(CommandRequest.simple(type), UNKNOWN, held));
        } catch (InvalidInput input) {
            wrong = input.field();
        }

        assertThat(wrong.equals("type")).as(type).isEqualTo(!TYPES.contains(type));
        read.ifPresent(command -> assertThat(command.kind()).isEqualTo(kind));
    }

    @Test
    void hasAPageThatKnowsEachTypeOfCommand() throws IOException {
        assertThat(described("CommandRequest", "type")).isEqualTo(TYPES);
    }

    @Test
    void hasAPageThatKnowsWhichNeedControl() throws IOException {
        String controls = Files.readString(PAGE.resolve("../state/controls.svelte.ts"));
        String table = controls.substring(controls.indexOf("const PURPOSES"));

        for (CommandKind kind : CommandKind.values()) {
            String type = WireNames.lowerFirst(kind.word());
            String purpose = switch (kind.purpose()) {
                case READ -> "read";
                case SAFETY, PAUSE -> "safety";
                case FLY, CHANGE -> "control";
            };
            if (TYPES.contains(type)) {
                assertThat(table).contains("  " + type + ": '" + purpose + "',");
            }
        }
    }

    @Test
    void hasAPageThatKnowsEachOutcome() throws IOException {
        assertThat(described("CommandOutcomeView", "result"))
                .isEqualTo(
                        Stream.of(Outcome.Kind.values()).map(Outcome.Kind::word).collect(Collectors.toSet()));
    }

    @Test
    void hasAPageThatKnowsEachItemOfAMission() throws IOException {
        assertThat(described("MissionItemView", "type"))
                .isEqualTo(Stream.of(MissionItem.Kind.values())
                        .map(MissionItem.Kind::word)
                        .collect(Collectors.toSet()));
    }

    /** The values of a member as the page takes them: its types are written from the description. */
    private static Set<String> described(String schema, String member) throws IOException {
        return new JsonMapper()
                .readTree(Files.readString(DESCRIPTION))
                .path("components")
                .path("schemas")
                .path(schema)
                .path("properties")
                .path(member)
                .path("enum")
                .valueStream()
                .filter(JsonNode::isString)
                .map(JsonNode::stringValue)
                .collect(Collectors.toSet());
    }
}

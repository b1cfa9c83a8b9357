package org.dronemap.ws.service;

import static org.assertj.core.api.Assertions.assertThat;

import jakarta.jws.WebParam;
import java.io.IOException;
import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
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
import org.junit.jupiter.params.provider.MethodSource;
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
    private static final Alternatives ALTERNATIVES =
            Alternatives.of(CommandRequest.class).orElseThrow();
    private static final Set<String> TYPES = ALTERNATIVES.records().keySet();

    /** Fence, rally points and the download of a log have addresses of their own; some are given by the cloud alone. */
    private static boolean isForClients(CommandKind kind) {
        return switch (kind) {
            case READ_FENCE,
                    SET_FENCE,
                    READ_RALLY_POINTS,
                    SET_RALLY_POINTS,
                    DOWNLOAD_LOG,
                    SET_RETURN_HEIGHT,
                    RETURN_ON_LOSS,
                    SET_CLOUD_LOSS,
                    PUT_BACK -> false;
            case ARM,
                    DISARM,
                    SET_MODE,
                    TAKE_OFF,
                    LAND,
                    RETURN_TO_LAUNCH,
                    HOLD,
                    EMERGENCY_STOP,
                    GO_TO,
                    GO_TO_LOCAL,
                    TURN,
                    UPLOAD_MISSION,
                    START_MISSION,
                    PAUSE_MISSION,
                    CLEAR_MISSION,
                    SET_HOME,
                    READ_HOME,
                    TAKE_PICTURE,
                    SET_RELAY,
                    READ_PARAMETERS,
                    SET_PARAMETERS,
                    READ_LOGS,
                    READ_MAP -> true;
        };
    }

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
    void hasABodyForEachTypeAndNoneForWhatClientsDoNotAskFor(CommandKind kind) {
        Class<?> body = ALTERNATIVES.records().get(WireNames.lowerFirst(kind.word()));

        assertThat(body != null).as("a body for " + kind).isEqualTo(isForClients(kind));
    }

    static Stream<String> types() {
        return TYPES.stream();
    }

    @ParameterizedTest
    @MethodSource("types")
    void readsWhatItTellsClientsThatThereIs(String type) {
        CommandRequest request = new JsonReader().read("{\"type\":\"" + type + "\"}", CommandRequest.class);
        ParameterSet held = ParameterSet.of(List.of(), Instant.EPOCH);

        assertThat(WireNames.lowerFirst(request.kind().word())).isEqualTo(type);
        try {
            assertThat(CommandReader.asked(request, UNKNOWN, held).kind()).isEqualTo(request.kind());
        } catch (InvalidInput missing) {
            assertThat(request.getClass().getRecordComponents())
                    .extracting(RecordComponent::getName)
                    .contains(missing.field());
        }
    }

    @Test
    void hasAPageThatKnowsEachTypeOfCommand() throws IOException {
        Set<String> described = schema("CommandRequest")
                .path("discriminator")
                .path("mapping")
                .propertyStream()
                .map(Map.Entry::getKey)
                .collect(Collectors.toSet());

        assertThat(described).isEqualTo(TYPES);
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
        return schema(schema)
                .path("properties")
                .path(member)
                .path("enum")
                .valueStream()
                .filter(JsonNode::isString)
                .map(JsonNode::stringValue)
                .collect(Collectors.toSet());
    }

    private static JsonNode schema(String name) throws IOException {
        return new JsonMapper()
                .readTree(Files.readString(DESCRIPTION))
                .path("components")
                .path("schemas")
                .path(name);
    }
}

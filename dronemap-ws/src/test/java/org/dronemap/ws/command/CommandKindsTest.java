package org.dronemap.ws.command;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.RecordComponent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.command.Outcome;
import org.dronemap.core.drone.Capabilities;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.DroneKey;
import org.dronemap.core.drone.DroneState;
import org.dronemap.core.drone.Identification;
import org.dronemap.core.drone.IdentityTrust;
import org.dronemap.core.drone.LinkQuality;
import org.dronemap.core.drone.LinkState;
import org.dronemap.core.drone.LinkStatus;
import org.dronemap.core.drone.MissionProgress;
import org.dronemap.core.drone.PayloadState;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.core.parameter.ParameterSet;
import org.dronemap.ws.mission.MissionItemView;
import org.dronemap.ws.problem.InvalidInput;
import org.dronemap.ws.reading.JsonCodec;
import org.dronemap.ws.reading.RecordAlternatives;
import org.dronemap.ws.reading.WireNames;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.MethodSource;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Each way in knows each kind of command, mission item and outcome, or says here why it does not. */
class CommandKindsTest {
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
            IdentityTrust.UNPROVED,
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
            PayloadState.UNKNOWN,
            MissionProgress.UNKNOWN,
            List.of(),
            Instant.EPOCH,
            1,
            null);
    private static final Path DESCRIPTION = Path.of("src", "test", "resources", "wire", "openapi.json");
    private static final Path CONTROLLER =
            Path.of("src", "test", "resources", "wire", "wsdl", "MAVLinkControllerService.wsdl");
    private static final Pattern GIVING = Pattern.compile(
            "name=\"(\\w+)\">\\s*<wsdl:documentation>Give a command \\(operator\\): (\\w+)</wsdl:documentation>");
    private static final RecordAlternatives ALTERNATIVES =
            RecordAlternatives.of(CommandRequest.class).orElseThrow();
    private static final Set<String> TYPES = ALTERNATIVES.records().keySet();

    /** Fence, rally points and the download of a log have addresses of their own; the rest is given by the cloud alone. */
    private static final Set<CommandKind> WITHOUT_A_BODY = EnumSet.of(
            CommandKind.READ_FENCE,
            CommandKind.SET_FENCE,
            CommandKind.READ_RALLY_POINTS,
            CommandKind.SET_RALLY_POINTS,
            CommandKind.DOWNLOAD_LOG,
            CommandKind.SET_RETURN_HEIGHT,
            CommandKind.RETURN_ON_LOSS,
            CommandKind.SET_CLOUD_LOSS,
            CommandKind.PUT_BACK);

    @Test
    void hasAnOperationOfSoapForEachTypeAndNoneBeside() throws IOException {
        Map<String, String> giving = new TreeMap<>();
        Matcher found = GIVING.matcher(Files.readString(CONTROLLER));
        while (found.find()) {
            giving.put(found.group(2), found.group(1));
        }

        assertThat(giving.keySet()).isEqualTo(TYPES);
        assertThat(giving).allSatisfy((type, name) -> assertThat(name).isEqualToIgnoringCase(type));
        assertThat(giving).containsEntry("takeOff", "takeoff").containsEntry("goTo", "goto");
    }

    @ParameterizedTest
    @EnumSource
    void hasABodyForEachTypeAndNoneForWhatClientsDoNotAskFor(CommandKind kind) {
        Class<?> body = ALTERNATIVES.records().get(WireNames.lowerFirst(kind.word()));

        assertThat(body != null).as("a body for " + kind).isEqualTo(!WITHOUT_A_BODY.contains(kind));
    }

    static Stream<String> types() {
        return TYPES.stream();
    }

    @ParameterizedTest
    @MethodSource("types")
    void readsWhatItTellsClientsThatThereIs(String type) {
        CommandRequest request = new JsonCodec().read("{\"type\":\"" + type + "\"}", CommandRequest.class);
        ParameterSet held = ParameterSet.of(List.of(), Instant.EPOCH);

        assertThat(WireNames.lowerFirst(request.kind().word())).isEqualTo(type);
        try {
            assertThat(request.command(UNKNOWN, held).kind()).isEqualTo(request.kind());
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

    /** From which the page's table is written: whether it needs control to give one. */
    @Test
    void saysWhatEachCommandIsFor() throws IOException {
        JsonNode purposes =
                schema("CommandView").path("properties").path("type").path("x-purposes");

        assertThat(purposes.propertyStream().map(Map.Entry::getKey))
                .containsExactlyInAnyOrderElementsOf(described("CommandView", "type"));
        assertThat(CommandKind.values())
                .allSatisfy(kind -> assertThat(
                                purposes.path(WireNames.lowerFirst(kind.word())).asString())
                        .isEqualTo(WireNames.camel(kind.purpose())));
    }

    @Test
    void hasAPageThatKnowsEachOutcome() throws IOException {
        assertThat(described("CommandOutcomeView", "result"))
                .isEqualTo(
                        Stream.of(Outcome.Kind.values()).map(Outcome.Kind::word).collect(Collectors.toSet()));
    }

    @Test
    void hasAPageThatKnowsEachItemOfAMission() throws IOException {
        assertThat(RecordAlternatives.of(MissionItemView.class)
                        .orElseThrow()
                        .records()
                        .keySet())
                .containsExactlyElementsOf(Stream.of(MissionItem.Kind.values())
                        .map(MissionItem.Kind::word)
                        .toList())
                .hasSameElementsAs(
                        schema("MissionItemView").at("/discriminator/mapping").propertyNames());
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

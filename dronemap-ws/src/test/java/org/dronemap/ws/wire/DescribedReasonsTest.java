package org.dronemap.ws.wire;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;

/** Sentences in answers that tell why something is not so: each has a code beside it, or stands here with a reason. */
class DescribedReasonsTest {
    private static final List<String> DESCRIPTIONS = List.of("openapi.json", "asyncapi.json");
    private static final Set<String> WORDS = Set.of(
            "why", "reason", "refusal", "detail", "problem", "failure", "trouble", "faults", "message", "error", "note",
            "notice");
    private static final String OF_A_PERSON = "a person wrote it";
    private static final String HOW_IT_IS = "tells people how it is; what a program needs of that are members";
    private static final String OF_A_COMMAND = "is that of the command beside it, whose record has the code";
    private static final String OF_A_DRONE = "was written down as the drone or the gate said it";
    private static final String OF_A_SEARCH = "explains what a search came to; nobody asked for what it tells of";

    /** Those without a code. */
    private static final Map<String, String> OTHERS = Map.ofEntries(
            Map.entry("AuditVerdictView.detail", "tells people what was found; the verdict is a member"),
            Map.entry("AuditView.reason", "was written down as the caller was told it, in a record that never changes"),
            Map.entry("ControlAskedView.reason", OF_A_PERSON),
            Map.entry("ControlChangeView.reason", OF_A_PERSON),
            Map.entry("ControlAskRequest.reason", OF_A_PERSON),
            Map.entry("ControlRefuseRequest.reason", OF_A_PERSON),
            Map.entry("ControlTakeOverRequest.reason", OF_A_PERSON),
            Map.entry("StreamControlAskRequest.reason", OF_A_PERSON),
            Map.entry("StreamControlRefuseRequest.reason", OF_A_PERSON),
            Map.entry("StreamControlTakeOverRequest.reason", OF_A_PERSON),
            Map.entry("EndpointView.reason", "what the system says of a socket or a line"),
            Map.entry("EventView.reason", OF_A_COMMAND),
            Map.entry("NumberedEvent.reason", OF_A_COMMAND),
            Map.entry("DroneMissionView.notice", HOW_IT_IS),
            Map.entry("DispatchView.note", HOW_IT_IS),
            Map.entry("FollowView.note", HOW_IT_IS),
            Map.entry("RecoveryDroneView.note", HOW_IT_IS),
            Map.entry("RunDroneView.note", HOW_IT_IS),
            Map.entry("HealthEnd.why", HOW_IT_IS),
            Map.entry("HealthPart.why", HOW_IT_IS),
            Map.entry("HistoryView.trouble", HOW_IT_IS),
            Map.entry("FlightView.notice", HOW_IT_IS),
            Map.entry("GiftView.notice", HOW_IT_IS),
            Map.entry("RecordingRoomView.notice", HOW_IT_IS),
            Map.entry("RecordingView.notice", HOW_IT_IS),
            Map.entry("PlanResultView.faults", OF_A_SEARCH),
            Map.entry("PlanUnservedView.why", OF_A_SEARCH),
            Map.entry("RunWaypointView.why", OF_A_SEARCH),
            Map.entry("VirtualDroneRunView.why", OF_A_SEARCH),
            Map.entry("VirtualDroneShareView.why", OF_A_SEARCH),
            Map.entry("PlanView.why", "the state tells that the search failed, for which there is one reason"),
            Map.entry("ReplayView.failure", "the state tells that it failed; what the system says of the file"),
            Map.entry("StreamError.problem", "has its code within"),
            Map.entry("VirtualDroneRunView.detail", OF_A_DRONE),
            Map.entry("VirtualDroneShareView.detail", OF_A_DRONE),
            Map.entry("WaitingView.reason", "is a word for programs itself"),
            Map.entry("WaitingView.why", "the reason beside it is for programs"));

    @Test
    void haveACodeBesideThem() throws IOException {
        assertThat(withoutCode()).containsExactlyElementsOf(new TreeSet<>(OTHERS.keySet()));
    }

    private static Set<String> withoutCode() throws IOException {
        Set<String> found = new TreeSet<>();
        for (String description : DESCRIPTIONS) {
            schemas(description).forEach((name, members) -> {
                if (!members.contains("code")) {
                    members.stream().filter(WORDS::contains).forEach(member -> found.add(name + "." + member));
                }
            });
        }
        return found;
    }

    private static Map<String, List<String>> schemas(String description) throws IOException {
        JsonNode all = new ObjectMapper()
                .readTree(Files.readString(Path.of("src/test/resources/wire", description)))
                .path("components")
                .path("schemas");
        Map<String, List<String>> found = new TreeMap<>();
        all.forEachEntry((name, schema) -> {
            List<String> members = new ArrayList<>();
            Stream.of(schema.path("properties").propertyNames().toArray(String[]::new))
                    .forEach(members::add);
            found.put(name, members);
        });
        return found;
    }
}

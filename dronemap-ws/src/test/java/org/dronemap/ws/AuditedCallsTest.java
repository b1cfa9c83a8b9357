package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.net.http.HttpRequest;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Function;
import org.dronemap.core.audit.AuditEntry;
import org.dronemap.core.audit.AuditOutcome;
import org.dronemap.core.audit.AuditRecord;
import org.dronemap.core.command.CommandKind;
import org.dronemap.core.drone.Capability;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.FlightPhase;
import org.dronemap.core.event.DroneEvent;
import org.dronemap.core.mission.MissionItem;
import org.dronemap.ws.testserver.AuditRecordComparison;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.OrganisationMember;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.SuccessfulCalls;
import org.dronemap.ws.testserver.TestHttpClient;
import org.junit.jupiter.api.Test;

/**
 * Carries out, with success, all that the running server exposes and that may change something: each leaves exactly one
 * record, which says so. What the server offers and nobody here knows how to do fails the test.
 */
class AuditedCallsTest extends SuccessfulCallTrial {
    /** A sign of life, every two seconds. */
    private static final String HEARTBEAT = "POST /api/v1/drones/{id}/control/heartbeat";

    /** Each second, of each phone that is followed. */
    private static final String POSITIONS = "POST /api/v1/follows/{id}/positions";

    private static final String COMMANDS = "POST /api/v1/drones/{id}/commands";

    /** What this vehicle cannot do. */
    private static final String CANNOT = "goToLocal|emergencyStop|readMap";

    private static final Set<AuditOutcome> DONE = Set.of(AuditOutcome.SUCCEEDED, AuditOutcome.UNDER_WAY);

    @Test
    void eachOperationOfRestThatSucceedsLeavesOneRecordThatSaysSo() {
        List<String> wrong = new ArrayList<>();
        int done = 0;
        for (String operation : faces.rest()) {
            boolean changes = !operation.startsWith("GET ") || operation.endsWith("/oidc/callback");
            if (!changes || operation.equals(HEARTBEAT) || operation.equals(POSITIONS)) {
                continue;
            }
            Optional<SuccessfulCalls.PreparedCall> deed = deed(operation);
            if (deed.isEmpty()) {
                wrong.add("Nobody knows how to do " + operation);
                continue;
            }
            int before = house.records().size();
            TestHttpClient.Answer answer = deed.get().make();
            List<AuditEntry> left = since(before);
            boolean right = answer.status() < 400
                    && left.size() == 1
                    && isOf(left.get(0), operation, Set.of("rest", "page"))
                    && DONE.contains(left.get(0).outcome());
            if (!right) {
                wrong.add(operation + " is answered " + answer.status() + " "
                        + answer.raw().body() + " and leaves " + left);
            }
            done++;
        }
        assertThat(wrong).isEmpty();
        assertThat(done).isGreaterThan(75);
    }

    /** Commands are recorded by what they command. */
    private static boolean isOf(AuditEntry entry, String operation, Set<String> faces) {
        boolean ofDrone = operation.contains("/drones/{id}");
        return (entry.operation().equals(operation) || entry.command() != null)
                && (!ofDrone || entry.drone() != null)
                && (entry.by() != null || operation.equals("POST /api/v1/registrations"))
                && faces.contains(entry.face());
    }

    @Test
    void tellsWhichDroneServesAVirtualOneAndWhy() {
        int before = house.records().size();
        String resume = "POST /api/v1/virtual-drones/{id}/resume";
        assertThat(deed(resume)).isPresent();

        List<AuditEntry> left = house.records().stream()
                .skip(before)
                .map(AuditRecord::entry)
                .filter(entry -> entry.operation().matches("bindDrone|releaseDrone"))
                .toList();
        assertThat(left).extracting(AuditEntry::operation).containsExactly("bindDrone", "releaseDrone");
        assertThat(left.get(0).face()).isEqualTo("virtual");
        assertThat(left.get(0).reason()).contains(left.get(0).drone() + " was chosen");
        assertThat(left.get(1).drone()).isEqualTo(left.get(0).drone());
    }

    @Test
    void eachOperationOfSoapThatSucceedsLeavesTheRecordThatItLeavesOverRest() {
        List<String> wrong = new ArrayList<>();
        int done = 0;
        for (String operation : faces.soap()) {
            String rest = faces.restOf(operation);
            if (rest.startsWith("GET ") || Set.of(HEARTBEAT, POSITIONS).contains(rest) || operation.matches(CANNOT)) {
                continue;
            }
            if (deed(rest).orElseThrow().cookie() != null) {
                // Of somebody at a browser.
                continue;
            }
            Left byRest = left(operation, SuccessfulCalls.PreparedCall::make);
            Left bySoap = left(operation, deed -> faces.soap(deed, operation));
            boolean right = bySoap.answer().status() == 200
                    && bySoap.entries().size() == 1
                    && isOf(bySoap.entries().get(0), rest, Set.of("soap"))
                    && DONE.contains(bySoap.entries().get(0).outcome());
            if (!right) {
                wrong.add(
                        operation + " is answered " + bySoap.answer().raw().body() + " and leaves " + bySoap.entries());
            } else if (!bySoap.told().equals(byRest.told())) {
                wrong.add(operation + " leaves " + bySoap.told() + ", over REST " + byRest.told());
            }
            done++;
        }
        assertThat(wrong).isEmpty();
        assertThat(done).isGreaterThan(90);
    }

    /** What one call is answered and leaves. */
    private record Left(AuditRecordComparison records, TestHttpClient.Answer answer, List<AuditEntry> entries) {
        List<Map<String, String>> told() {
            return entries.stream().map(records::told).toList();
        }
    }

    private Left left(String operation, Function<SuccessfulCalls.PreparedCall, TestHttpClient.Answer> call) {
        String rest = faces.restOf(operation);
        SuccessfulCalls.PreparedCall deed = deed(rest).orElseThrow();
        if (rest.equals(COMMANDS)) {
            beReadyFor(operation);
            deed = deed.saying(
                    faces.commands().least(faces.commandOf(operation)).toString());
        }
        int before = house.records().size();
        TestHttpClient.Answer answer = call.apply(deed);
        return new Left(new AuditRecordComparison(rest, deed), answer, since(before));
    }

    private static String constant(String type) {
        return type.replaceAll("(?=[A-Z])", "_").toUpperCase(Locale.ROOT);
    }

    private void beReadyFor(String operation) {
        String control = "/api/v1/drones/" + vehicle.id() + "/control";
        for (OrganisationMember one : List.of(estate.administrator(), other)) {
            one.http().send(control, HttpRequest.Builder::DELETE);
        }
        boolean flying = CommandKind.valueOf(constant(faces.commandOf(operation)))
                        .needs()
                        .readiness()
                == Capability.Readiness.UNDER_WAY;
        FlightPhase phase = flying ? FlightPhase.IN_AIR : FlightPhase.ON_GROUND;
        vehicle.says(new DroneEvent.ModeReported("GUIDED", !operation.equals("arm")));
        vehicle.says(new DroneEvent.PhaseReported(phase));
        vehicle.says(new DroneEvent.MissionRead(List.of(new MissionItem.TakeOff(20)), null, true));
        ConditionWait.until(
                "it is heard",
                () -> house.cloud().drone(new DroneId(vehicle.id())).filter(state -> state.phase() == phase));
    }

    @Test
    void eachRequestOfTheStreamThatSucceedsLeavesOneRecordThatSaysSo() {
        beReadyFor("arm");
        try (RecordingStreamClient mine = RecordingStreamClient.withKey(
                        house, estate.administrator().key());
                RecordingStreamClient others = RecordingStreamClient.withKey(house, other.key())) {
            said(others, "\"control\",\"action\":\"take\"");
            said(mine, "\"control\",\"action\":\"request\",\"reason\":\"a survey\"");
            said(others, "\"control\",\"action\":\"refuse\",\"user\":\"our-root\"");
            said(mine, "\"control\",\"action\":\"request\"");
            said(others, "\"control\",\"action\":\"grant\",\"user\":\"our-root\"");
            said(mine, "\"control\",\"action\":\"handOver\",\"user\":\"our-other\"");
            said(mine, "\"control\",\"action\":\"takeOver\",\"reason\":\"smoke\"");
            said(mine, "\"command\",\"command\":{\"type\":\"readHome\"}");
            said(mine, "\"control\",\"action\":\"release\"");
        }
    }

    private int said;

    private void said(RecordingStreamClient stream, String about) {
        String id = "said-" + ++said;
        int before = house.records().size();
        stream.send("{\"requestId\":\"" + id + "\",\"drone\":\"" + vehicle.id() + "\",\"type\":" + about + "}");
        String answer = stream.await(
                        message -> message.path("requestId").asString("").equals(id))
                .toString();
        assertThat(answer).as(about).doesNotContain("\"error\"");
        // Answered in order, so that all is done that came before it.
        stream.send("{\"type\":\"nosuchtype\",\"requestId\":\"" + id + "-after\"}");
        stream.await(message -> message.path("requestId").asString("").equals(id + "-after"));
        List<AuditEntry> all = since(before).stream()
                .filter(entry -> !entry.operation().equals("unreadable"))
                .toList();
        assertThat(all).as(about).hasSize(1);
        AuditEntry left = all.get(0);
        assertThat(left.face()).isEqualTo("stream");
        assertThat(left.by()).as(about).isNotNull();
        assertThat(left.drone()).isEqualTo(vehicle.id());
        assertThat(left.outcome()).as(about).isIn(DONE);
    }
}

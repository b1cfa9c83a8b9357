package org.dronemap.ws;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.dronemap.core.audit.AuditEntry;
import org.dronemap.ws.reading.SecretGenerator;
import org.dronemap.ws.testserver.ExposedOperations;
import org.dronemap.ws.testserver.RecordingStreamClient;
import org.dronemap.ws.testserver.SampleBodies;
import org.dronemap.ws.testserver.SoapOperations;
import org.dronemap.ws.testserver.SuccessfulCalls;
import org.dronemap.ws.testserver.TestHttpClient;
import org.junit.jupiter.api.Test;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Puts secrets into every field of every call that may change something: no record has them. */
class AuditSecretsTest extends SuccessfulCallTrial {
    /** As people choose them: nothing tells them from a word. */
    private static final String PASSWORD = "canary of a person";

    private static final Pattern SECRET_MEMBER =
            Pattern.compile(".*/(password|current|next|key|secret|invitation|code|token)");
    /** Of calls that were not understood, no text is kept. */
    private static final Set<Integer> NOT_UNDERSTOOD = Set.of(400, 415, 422);

    private final JsonMapper json = new JsonMapper();
    private final List<String> wrong = new ArrayList<>();

    /** What servers make: keys, tickets, session and link keys, one-time passwords. */
    private static Map<String, String> made() {
        SecretGenerator secrets = new SecretGenerator();
        Map<String, String> all = new LinkedHashMap<>();
        all.put("a key", secrets.token());
        all.put("a key behind words", "of the survey: " + secrets.token());
        all.put("a link key", "c0ffee00".repeat(8));
        all.put("a one-time password", secrets.password());
        return all;
    }

    @Test
    void noRecordHasASecretThatStoodInABody() {
        int tried = 0;
        List<String> kinds = List.copyOf(made().values());
        for (String operation : faces.rest()) {
            Optional<SuccessfulCalls.PreparedCall> deed =
                    operation.startsWith("GET ") ? Optional.empty() : deed(operation);
            for (String at : deed.isEmpty() ? List.<String>of() : SampleBodies.texts(body(deed.get()))) {
                // The next kind of secret with each place, and what no rule can tell from a word in all of them.
                SuccessfulCalls.PreparedCall one = deed(operation).orElseThrow();
                boolean done = say(one, operation, at, kinds.get(tried++ % kinds.size()));
                say(done ? deed(operation).orElseThrow() : one, operation, at, PASSWORD);
            }
        }
        assertThat(wrong).isEmpty();
        assertThat(tried).isGreaterThan(50);
    }

    /** False when it was refused, and the same can be tried again. */
    private boolean say(SuccessfulCalls.PreparedCall deed, String operation, String at, String secret) {
        String changed = SampleBodies.with(body(deed), at, secret).toString();
        int before = house.records().size();
        TestHttpClient.Answer answer = deed.saying(changed).make();
        String left = since(before).toString();
        boolean kept = SECRET_MEMBER.matcher(at).matches()
                || NOT_UNDERSTOOD.contains(answer.status())
                || !secret.equals(PASSWORD);
        // Signs that the holder is there come all the time and are left out.
        boolean recorded = !operation.endsWith("/control/heartbeat");
        if ((recorded && since(before).isEmpty()) || (kept && left.contains(bare(secret)))) {
            wrong.add(operation + " with " + secret + " at " + at + ", answered " + answer.status() + ": " + left);
        }
        return answer.status() < 400;
    }

    /** The secret part. */
    private static String bare(String secret) {
        return secret.equals(PASSWORD) ? secret : secret.substring(secret.lastIndexOf(' ') + 1);
    }

    private JsonNode body(SuccessfulCalls.PreparedCall deed) {
        boolean isJson = deed.contentType().contains("json") && !deed.body().isEmpty();
        return isJson ? json.readTree(deed.body()) : json.createObjectNode();
    }

    @Test
    void noRecordHasASecretThatStoodInAnAddressOrAHeader() {
        for (String operation : faces.rest()) {
            if (operation.startsWith("GET ")) {
                continue;
            }
            for (String secret : made().values()) {
                String word = bare(secret);
                int before = house.records().size();
                faces.rest(
                        new TestHttpClient(house, word),
                        operation + "?ticket=" + word,
                        Map.of("id", word, "name", word, "identity", word, "drone", word));
                faces.rest(
                        estate.administrator().http(),
                        operation,
                        Map.of("id", word, "name", word, "identity", word, "drone", word));
                tell(operation, word, before);
            }
        }
        assertThat(wrong).isEmpty();
    }

    private void tell(String what, String secret, int before) {
        List<AuditEntry> left = since(before);
        if (left.toString().contains(secret)) {
            wrong.add(what + " with " + secret + ": " + left);
        }
    }

    @Test
    void noRecordHasASecretThatStoodInSoapOrOnTheStream() {
        int before = house.records().size();
        for (String secret : made().values()) {
            String word = bare(secret);
            for (String operation : faces.soap()) {
                faces.soapAsRest(estate.administrator().http(), operation, Map.of("id", word, "name", word));
                for (SoapOperations.OrganisationMember element : faces.elements(operation)) {
                    faces.soap(
                            estate.administrator().http(),
                            operation,
                            ExposedOperations.inOrder(faces.elementOf(operation), vehicle.id(), element.name(), word));
                }
            }
            try (RecordingStreamClient stream =
                    RecordingStreamClient.withKey(house, estate.administrator().key())) {
                for (String member : List.of("type", "drone", "action", "user", "reason", "requestId", "key")) {
                    stream.send("{\"type\":\"control\",\"drone\":\"" + vehicle.id() + "\",\"action\":\"take\",\""
                            + member + "\":\"" + word + "\"}");
                    stream.send("{\"type\":\"command\",\"drone\":\"" + vehicle.id()
                            + "\",\"command\":{\"type\":\"setMode\",\"mode\":\"" + word + "\",\"id\":\"" + word
                            + "\"}}");
                }
                stream.send("{\"type\":\"ping\"}");
                stream.await(message -> message.path("type").asString().equals("pong"));
            }
            tell("SOAP or stream", word, before);
        }
        assertThat(since(before)).hasSizeGreaterThan(100);
        assertThat(wrong).isEmpty();
    }
}

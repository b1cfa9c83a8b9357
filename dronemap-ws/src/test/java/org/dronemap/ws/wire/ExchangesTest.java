package org.dronemap.ws.wire;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.http.HttpRequest;
import java.net.http.HttpResponse;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronemap.ws.testserver.ConditionWait;
import org.dronemap.ws.testserver.LatchedCopter;
import org.dronemap.ws.testserver.LatchedPlanListener;
import org.dronemap.ws.testserver.ResponseLatch;
import org.dronemap.ws.testserver.TestHttpClient;
import org.dronemap.ws.testserver.TestServer;
import org.dronemap.ws.wiring.StreamPort;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * What curl, zeep, PHP's SoapClient and the page in a browser said to a server once is said again, in the same order, to a
 * server with two copters that do at once what they are told. What is answered is compared with the files, to the letter.
 */
class ExchangesTest {
    private static final String FOLDER = "exchanges";
    private static final List<String> TOLD =
            List.of("Allow", "Location", "Retry-After", "Set-Cookie", "WWW-Authenticate");
    /** For all looks together that wait for what a server does beside its answers. */
    private static final Duration PATIENCE = Duration.ofSeconds(6);

    private final List<LatchedCopter> copters = new ArrayList<>();
    private final ResponseLatch acting = new ResponseLatch();
    private final ResponseLatch planning = new ResponseLatch();
    private final Placeholders names = new Placeholders();
    private Duration patience = PATIENCE;

    @Test
    void areAnsweredAsApproved(@TempDir Path data) throws IOException {
        List<RecordedHttpExchange> exchanges = recorded();
        try (TestServer house = new TestServer(data, false)) {
            LatchedPlanListener.of(house, planning);
            copters.add(new LatchedCopter(house.cloud(), 14_551, "ArduCopter 1", acting));
            copters.add(new LatchedCopter(house.cloud(), 14_552, "ArduCopter 2", acting));
            names.bind(
                    "<local-key>", Files.readString(data.resolve("local-key")).strip());
            names.bind(
                    "<first-password>",
                    Files.readString(data.resolve("first-password.txt")).split("\\s")[1]);
            names.bind(
                    "<stream-port>", String.valueOf(house.bean(StreamPort.class).number()));
            names.bind("<port>", String.valueOf(house.httpPort()));

            replay(exchanges, new TestHttpClient(house, ""));
        }
    }

    private void replay(List<RecordedHttpExchange> exchanges, TestHttpClient nobody) {
        List<String> different = new ArrayList<>();
        int highest = Placeholders.highest(exchanges);
        String chosen = exchanges.stream().map(RecordedHttpExchange::asked).collect(Collectors.joining());
        for (RecordedHttpExchange exchange : exchanges) {
            String actual = asked(exchange, nobody);
            names.learn(exchange.answer(), actual);
            if (ApprovalFiles.isApproving()) {
                highest = names.name(actual, chosen, highest);
            }
            String shown = names.shown(actual);
            if (ApprovalFiles.isApproving()) {
                ApprovalFiles.write(ApprovalFiles.folder(FOLDER).resolve(exchange.name()), exchange.saying(shown));
            } else if (!shown.equals(exchange.answer())) {
                different.add(exchange.name() + difference(exchange.answer(), shown));
            }
        }
        assertThat(different)
                .as("If callers shall see this, approve it: docs/how-to-add/wire.md")
                .isEmpty();
    }

    private String asked(RecordedHttpExchange exchange, TestHttpClient nobody) {
        if (exchange.isLook()) {
            return looked(exchange, nobody);
        }
        ResponseLatch held =
                exchange.asksForAPlan() ? planning : exchange.waitsForNothing() ? acting : new ResponseLatch();
        held.shut();
        try {
            return answer(exchange, nobody);
        } finally {
            held.open();
            awaitOutcomes(nobody);
            copters.forEach(LatchedCopter::comesDown);
        }
    }

    /** Before anything else is asked, all orders have their outcome. */
    private void awaitOutcomes(TestHttpClient nobody) {
        for (LatchedCopter copter : copters) {
            ConditionWait.until(
                    "all orders are carried out",
                    () -> Optional.of(nobody.send(
                                    "/api/v1/drones/" + copter.id() + "/commands?limit=10",
                                    request ->
                                            request.header("Authorization", "Bearer " + names.filled("<local-key>"))))
                            .filter(answer -> !answer.raw().body().contains("\"outcome\":null")));
        }
    }

    /** Taken again until it shows what is expected; when something else is to be written, until nothing changes any more. */
    private String looked(RecordedHttpExchange exchange, TestHttpClient nobody) {
        long began = System.nanoTime();
        AtomicReference<String> before = new AtomicReference<>("");
        String actual = ConditionWait.until("an answer to " + exchange.address(), () -> {
            String now = answer(exchange, nobody);
            Duration waited = Duration.ofNanos(System.nanoTime() - began);
            if (isExpected(exchange, now) || isOver(exchange, before.getAndSet(now), now, waited)) {
                return Optional.of(now);
            }
            copters.forEach(LatchedCopter::comesDown);
            return Optional.empty();
        });
        patience = patience.minusNanos(System.nanoTime() - began);
        return actual;
    }

    private boolean isOver(RecordedHttpExchange exchange, String before, String actual, Duration waited) {
        return ApprovalFiles.isApproving()
                ? isSettled(exchange, before, actual, waited)
                : waited.compareTo(patience) > 0;
    }

    private boolean isExpected(RecordedHttpExchange exchange, String actual) {
        Placeholders tried = names.copy();
        tried.learn(exchange.answer(), actual);
        return tried.shown(actual).equals(exchange.answer());
    }

    private boolean isSettled(RecordedHttpExchange exchange, String before, String actual, Duration waited) {
        boolean far = stateOf(names.shown(actual)).equals(stateOf(exchange.answer()));
        boolean still = names.shown(before).equals(names.shown(actual));
        return waited.compareTo(Duration.ofMillis(far && still ? 700 : 3_000)) > 0;
    }

    /** Of a plan, a run or a follow: it goes on by itself. */
    private static String stateOf(String answer) {
        return answer.lines()
                .filter(line -> line.contains("\"state\" :") || line.contains("<state>"))
                .findFirst()
                .orElse("");
    }

    private String answer(RecordedHttpExchange exchange, TestHttpClient nobody) {
        String body = names.filled(exchange.body());
        TestHttpClient.Answer answer = nobody.send(names.filled(exchange.address()), request -> {
            exchange.headers().forEach(header -> {
                String[] parts = names.filled(header).split(": ?", 2);
                request.header(parts[0], parts[1]);
            });
            return request.method(
                    exchange.method(),
                    body.isEmpty() ? HttpRequest.BodyPublishers.noBody() : HttpRequest.BodyPublishers.ofString(body));
        });
        return readable(answer.raw());
    }

    private static String readable(HttpResponse<String> answer) {
        String type = answer.headers().firstValue("Content-Type").orElse("");
        StringBuilder text = new StringBuilder((answer.statusCode() + " " + type).strip() + "\n");
        for (String name : TOLD) {
            answer.headers().allValues(name).forEach(value -> text.append(name + ": " + value + "\n"));
        }
        String body = answer.body();
        if (type.contains("json") && !body.isEmpty()) {
            body = PrettyJson.of(PrettyJson.tree(body));
        } else if (type.contains("xml")) {
            body = body.replace("><", ">\n<");
        }
        return (text + "\n" + body).stripTrailing() + "\n";
    }

    private static String difference(String expected, String actual) {
        List<String> then = expected.lines().toList();
        List<String> now = actual.lines().toList();
        int at = 0;
        while (at < then.size() && at < now.size() && then.get(at).equals(now.get(at))) {
            at++;
        }
        return "\n  line " + (at + 1) + " of the answer was: " + line(then, at) + "\n  and is: " + line(now, at);
    }

    private static String line(List<String> lines, int at) {
        return at < lines.size() ? lines.get(at) : "(nothing)";
    }

    private static List<RecordedHttpExchange> recorded() {
        try (Stream<Path> files = Files.list(ApprovalFiles.folder(FOLDER))) {
            return files.sorted().map(RecordedHttpExchange::read).toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}

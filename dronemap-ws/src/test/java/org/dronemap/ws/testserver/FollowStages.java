package org.dronemap.ws.testserver;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronemap.core.command.Command;
import org.dronemap.core.geo.Geodetic;

/** Follows of one tenant, each with a copter of its own, brought to the stages that docs/following.md has. */
public final class FollowStages {
    public static final String PATH = "/api/v1/follows";

    private static final Geodetic HOME = new Geodetic(47.3977, 8.5456);

    private final TestTenant tenant;
    private final TestHttpClient supervisor;
    private final List<Staged> all = new ArrayList<>();

    public FollowStages(TestTenant tenant, TestHttpClient supervisor) {
        this.tenant = tenant;
        this.supervisor = supervisor;
    }

    /** A follow for which a stage is wanted, and who asked for it. */
    public record Staged(String stage, String id, ImmediateCopter copter, TestHttpClient owner) {
        public String path() {
            return PATH + "/" + id;
        }
    }

    /** By stage, what comes of each operation and event. */
    public static Map<String, Map<String, String>> table() throws IOException {
        List<String> lines = Files.readAllLines(Path.of("../docs/following.md"));
        String head = lines.stream()
                .filter(line -> line.startsWith("| operation"))
                .findFirst()
                .orElseThrow();
        String[] stages = head.split(" *\\| *");
        Map<String, Map<String, String>> table = new LinkedHashMap<>();
        for (String line : lines) {
            String[] cells = line.split(" *\\| *");
            if (cells.length == stages.length && !line.equals(head) && !cells[1].startsWith("-")) {
                for (int column = 2; column < cells.length; column++) {
                    table.computeIfAbsent(stages[column], stage -> new LinkedHashMap<>())
                            .put(cells[1], cells[column]);
                }
            }
        }
        return table;
    }

    /** It is brought to its stage with all others. */
    public Staged open(String stage, TestHttpClient owner) {
        ImmediateCopter copter = tenant.copter(tenant.unique("Copter"), HOME)
                .wellHeard(tenant.server().cloud());
        if (stage.equals("starting")) {
            copter.staysDown();
        }
        TestHttpClient.Answer opened =
                owner.post(PATH, "{\"latitude\":47.398,\"longitude\":8.5456,\"drone\":\"" + copter.id() + "\"}");
        assertThat(opened.status()).as(opened.raw().body()).isEqualTo(201);
        Staged staged = new Staged(stage, opened.text("id"), copter, owner);
        all.add(staged);
        return staged;
    }

    /** Each to its stage, all at the same time. */
    public void bring() {
        List<Staged> started =
                all.stream().filter(one -> !one.stage().equals("allocated")).toList();
        started.forEach(one -> ask(one.owner(), one.path() + "/start"));
        List<Staged> flying =
                started.stream().filter(one -> !one.stage().equals("starting")).toList();
        flying.forEach(one -> await(one, "tracking"));
        flying.forEach(this::further);
        // One that stays down has been armed by then.
        all.forEach(one -> await(one, one.stage()));
        started.stream()
                .filter(one -> one.stage().equals("starting"))
                .forEach(one -> ConditionWait.until(
                        "it is armed",
                        () -> one.copter().performed().stream()
                                .filter(Command.TakeOff.class::isInstance)
                                .findFirst()));
    }

    private void further(Staged one) {
        switch (one.stage()) {
            case "paused" -> ask(one.owner(), one.path() + "/pause");
            case "returning" -> ask(one.owner(), one.path() + "/stop");
            // A pilot keeps it for as long as it flies.
            case "suspended" -> one.copter().isIn("LOITER");
            default -> {}
        }
    }

    private static void ask(TestHttpClient who, String path) {
        TestHttpClient.Answer answer = who.post(path, "");
        assertThat(answer.status()).as(answer.raw().body()).isEqualTo(200);
    }

    /** By the supervisor. */
    public void takeOver(Staged one) {
        TestHttpClient.Answer taken = supervisor.post(
                "/api/v1/drones/" + one.copter().id() + "/control/take-over", "{\"reason\":\"a look\"}");
        assertThat(taken.status()).as(taken.raw().body()).isEqualTo(200);
    }

    /** As the supervisor sees it. */
    public String state(Staged one) {
        return supervisor.get(one.path()).text("state");
    }

    public void await(Staged one, String... states) {
        ConditionWait.until(
                one + ": the follow is " + String.join(" or ", states),
                () -> Optional.of(state(one)).filter(List.of(states)::contains));
    }
}

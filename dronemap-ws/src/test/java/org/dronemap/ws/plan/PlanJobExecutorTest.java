package org.dronemap.ws.plan;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dronemap.cognitive.engine.SearchProgress;
import org.dronemap.cognitive.problem.Craft;
import org.dronemap.cognitive.problem.Performance;
import org.dronemap.cognitive.problem.Place;
import org.dronemap.cognitive.problem.PlanningProblem;
import org.dronemap.cognitive.problem.Waypoint;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.drone.VehicleKind;
import org.dronemap.core.geo.Geodetic;
import org.dronemap.core.organisation.OrganisationId;
import org.dronemap.core.time.RealTime;
import org.dronemap.core.time.SteppedTime;
import org.dronemap.ws.problem.Rejection;
import org.dronemap.ws.problem.RejectionKind;
import org.dronemap.ws.testserver.ConditionWait;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;

/** What may be planned at once, and for how long it is remembered. */
class PlanJobExecutorTest {
    private static final Duration LONG = Duration.ofMinutes(5);
    private static final PlanJobExecutor.Limits BOUNDS = new PlanJobExecutor.Limits(1, 2, 4, 10, Duration.ofHours(1));

    private final SteppedTime time = new SteppedTime(Instant.EPOCH);
    private PlanJobExecutor desk = new PlanJobExecutor(BOUNDS, time);
    private int asked;

    @AfterEach
    void close() {
        desk.close();
    }

    private PlanJob job(Duration search) {
        Place home = new Place(new Geodetic(47.3977, 8.5456), 488);
        Craft craft = Craft.atHome(new DroneId("d1"), home, Performance.of(VehicleKind.MULTICOPTER));
        List<Waypoint> waypoints = new ArrayList<>();
        for (int i = 0; i < 30; i++) {
            Geodetic point = new Geodetic(47.398 + 0.0003 * (i % 7), 8.546 + 0.0004 * (i * i % 11) + 0.00001 * i);
            waypoints.add(Waypoint.at("w" + i, new Place(point, 520)));
        }
        PlanningProblem problem = PlanningProblem.of(waypoints, List.of(craft));
        asked++;
        return new PlanJob(
                "plan" + asked,
                new PlanJob.Origin("ann", "#1", OrganisationId.HOME, Instant.EPOCH),
                new PlanJobInput(problem, List.of(), search, 1));
    }

    private PlanJob submitted(Duration search) {
        PlanJob job = job(search);
        desk.submit(job);
        return job;
    }

    private static void await(PlanJob job, PlanJob.State state) {
        ConditionWait.until(
                "the plan is " + state,
                () -> Optional.of(job).filter(one -> one.status().state() == state));
    }

    @Test
    void refusesWithASentenceWhenTheQueueIsFull() {
        desk = new PlanJobExecutor(BOUNDS, new RealTime());
        PlanJob first = submitted(LONG);
        await(first, PlanJob.State.RUNNING);
        PlanJob second = submitted(LONG);
        submitted(LONG);

        assertThatThrownBy(() -> submitted(LONG))
                .isInstanceOfSatisfying(
                        Rejection.class, refused -> assertThat(refused.kind()).isEqualTo(RejectionKind.UNAVAILABLE))
                .hasMessageContaining("2 plans wait to be worked out already");

        desk.remove(second);
        submitted(LONG);
        assertThat(second.status().state()).isEqualTo(PlanJob.State.CANCELLED);
        assertThat(first.status().state()).isEqualTo(PlanJob.State.RUNNING);
    }

    @Test
    void forgetsTheOldestThatHasEndedWhenThereAreTooMany() {
        List<PlanJob> jobs = new ArrayList<>();
        for (int i = 0; i < 4; i++) {
            jobs.add(submitted(Duration.ofMillis(10)));
            time.settle();
            assertThat(jobs.get(i).status().state()).isEqualTo(PlanJob.State.FINISHED);
        }
        PlanJob another = submitted(Duration.ofMillis(10));

        assertThat(desk.find(jobs.get(0).id())).isEmpty();
        assertThat(desk.find(jobs.get(1).id())).isPresent();
        time.settle();
        assertThat(another.status().state()).isEqualTo(PlanJob.State.FINISHED);
    }

    @Test
    void forgetsWhatEndedLongAgo() {
        PlanJob job = submitted(Duration.ofMillis(10));
        time.settle();
        assertThat(job.status().state()).isEqualTo(PlanJob.State.FINISHED);
        assertThat(desk.jobs(OrganisationId.HOME)).containsExactly(job);

        time.advance(Duration.ofMinutes(61));
        assertThat(desk.jobs(OrganisationId.HOME)).isEmpty();
    }

    @Test
    void keepsOnlySomeOfManyImprovements() {
        PlanJob job = job(LONG);
        job.begin();
        for (int i = 0; i < 1_000; i++) {
            job.improve(new PlanJob.Step(i, new SearchProgress(1_000 - i, 0, 0, 0.5, i)), new int[][] {{0}});
        }

        List<PlanJob.Step> steps = job.status().steps();
        assertThat(steps).hasSizeLessThanOrEqualTo(200);
        assertThat(steps.get(0).seconds()).isZero();
        assertThat(steps.get(steps.size() - 1).seconds()).isEqualTo(999);
    }
}

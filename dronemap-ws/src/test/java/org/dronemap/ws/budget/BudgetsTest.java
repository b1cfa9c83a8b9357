package org.dronemap.ws.budget;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.dronemap.ws.problem.RateLimitRejection;
import org.junit.jupiter.api.Test;

class BudgetsTest {
    private long now = TimeUnit.HOURS.toNanos(5);
    private final Budgets budgets = new Budgets(new BudgetRates(Map.of(WorkKind.COMMAND, 2.0)), () -> now);

    private int taken(String user) {
        int times = 0;
        while (true) {
            try {
                budgets.charge(WorkKind.COMMAND, user);
                times++;
            } catch (RateLimitRejection refused) {
                assertThat(refused.retryAfterSeconds()).isEqualTo(1);
                return times;
            }
        }
    }

    @Test
    void givesTenSecondsWorthAtOnceAndThenTheRate() {
        assertThat(taken("ann")).isEqualTo(20);
        now += TimeUnit.SECONDS.toNanos(3);
        assertThat(taken("ann")).isEqualTo(6);
        now += TimeUnit.DAYS.toNanos(1);
        assertThat(taken("ann")).isEqualTo(20);
    }

    @Test
    void keepsUsersAndKindsOfWorkApart() {
        taken("ann");
        assertThat(taken("bob")).isEqualTo(20);
        for (int times = 0; times < 1_000; times++) {
            budgets.charge(WorkKind.REQUEST, "ann");
        }
        assertThat(budgets.refusedCount(WorkKind.COMMAND)).isEqualTo(2);
        assertThat(budgets.refusedCount(WorkKind.REQUEST)).isZero();
    }

    @Test
    void saysHowLongToWaitForTheNext() {
        Budgets slow = new Budgets(new BudgetRates(Map.of(WorkKind.EXPORT, 0.1)), () -> now);
        slow.charge(WorkKind.EXPORT, "ann");

        assertThatThrownBy(() -> slow.charge(WorkKind.EXPORT, "ann"))
                .hasMessage("More than 0.1 exports a second for a while; wait 10 s and try again.");
        now += TimeUnit.SECONDS.toNanos(10);
        slow.charge(WorkKind.EXPORT, "ann");
    }

    @Test
    void remembersABoundedNumberOfUsersAndThoseThatAskLast() {
        taken("ann");
        for (int user = 0; user < 9_999; user++) {
            budgets.charge(WorkKind.COMMAND, "user" + user);
        }
        assertThat(taken("ann")).as("still remembered").isZero();
        for (int user = 0; user < 10_000; user++) {
            budgets.charge(WorkKind.COMMAND, "another" + user);
        }
        assertThat(taken("ann")).as("forgotten").isEqualTo(20);
    }
}

package org.dronemap.ws.budget;

import java.time.Duration;
import java.util.EnumMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.atomic.LongAdder;
import java.util.function.LongSupplier;
import org.dronemap.ws.problem.ProblemParameter;
import org.dronemap.ws.problem.RateLimitRejection;
import org.dronemap.ws.problem.ServerProblem;
import org.jspecify.annotations.Nullable;

/**
 * Rate limits on the work of each user, by kind of work; unused budget accumulates for up to ten seconds. Who was quiet
 * for a while may do ten seconds' worth at once. Bounded: of those who are remembered, whoever asked longest ago is
 * forgotten first. Any thread.
 */
public final class Budgets {
    private static final double SECONDS_SAVED = 10;
    private static final int MOST_REMEMBERED = 10_000;
    private static final double NANOS = 1e9;

    private final BudgetRates rates;
    private final LongSupplier nanoClock;
    private final Map<WorkKind, LongAdder> refused = new EnumMap<>(WorkKind.class);

    /** Guarded by this. */
    private final Map<BudgetKey, Balance> purses = new LinkedHashMap<>(16, 0.75f, true) {
        private static final long serialVersionUID = 1L;

        @Override
        protected boolean removeEldestEntry(Map.Entry<BudgetKey, Balance> eldest) {
            return size() > MOST_REMEMBERED;
        }
    };

    private record BudgetKey(WorkKind work, String user) {}

    /** Budget left at a point in time. */
    private record Balance(double left, long atNanos) {}

    /** {@code nanoClock} is monotonic. */
    public Budgets(BudgetRates rates, LongSupplier nanoClock) {
        this.rates = rates;
        this.nanoClock = nanoClock;
        for (WorkKind work : WorkKind.values()) {
            refused.put(work, new LongAdder());
        }
    }

    /**
     * Takes one of that work from the user's budget.
     *
     * @throws RateLimitRejection when there is none left, with how long to wait
     */
    public void charge(WorkKind work, String user) {
        Double rate = rates.perSecond().get(work);
        if (rate == null) {
            return;
        }
        double missing = missing(new BudgetKey(work, user), rate);
        if (missing > 0) {
            count(work).increment();
            throw RateLimitRejection.of(
                    ServerProblem.BUDGET_SPENT,
                    "More than " + number(rate) + " " + work.plural() + " a second for a while",
                    Duration.ofNanos((long) (missing / rate * NANOS)),
                    ProblemParameter.WHAT.is(work.plural()));
        }
    }

    /** Nothing when it could be paid. */
    private synchronized double missing(BudgetKey whose, double rate) {
        long now = nanoClock.getAsLong();
        double most = Math.max(1, rate * SECONDS_SAVED);
        Balance before = purses.get(whose);
        double left = before == null ? most : Math.min(most, before.left() + (now - before.atNanos()) / NANOS * rate);
        purses.put(whose, new Balance(left < 1 ? left : left - 1, now));
        return left < 1 ? 1 - left : 0;
    }

    private LongAdder count(WorkKind work) {
        @Nullable LongAdder adder = refused.get(work);
        if (adder == null) {
            throw new IllegalStateException("no count of " + work);
        }
        return adder;
    }

    /** How often that work was refused since the start. */
    public long refusedCount(WorkKind work) {
        return count(work).sum();
    }

    private static String number(double rate) {
        return rate == Math.rint(rate) ? String.valueOf((long) rate) : String.valueOf(rate);
    }
}

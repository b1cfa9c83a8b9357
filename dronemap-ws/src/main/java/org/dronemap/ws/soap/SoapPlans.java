package org.dronemap.ws.soap;

import java.time.Duration;
import java.util.List;
import org.dronemap.ws.service.Caller;
import org.dronemap.ws.service.PlanRequest;
import org.dronemap.ws.service.PlanService;
import org.jspecify.annotations.Nullable;

/** Plans for several drones over SOAP. Any thread; accepting keeps its request's thread for up to 30 s. */
public final class SoapPlans {
    private static final Duration LONGEST_WAIT = Duration.ofSeconds(30);

    private final SoapCaller caller;
    private final PlanService plans;

    public SoapPlans(SoapCaller caller, PlanService plans) {
        this.caller = caller;
        this.plans = plans;
    }

    /** What is to be planned, as a caller wrote it. */
    record Wish(
            @Nullable List<String> drones,
            @Nullable List<SoapVisit> visits,
            @Nullable SoapObjective objective,
            @Nullable SoapWind wind,
            @Nullable Double seconds) {
        private PlanRequest request() {
            return new PlanRequest(
                    visits == null
                            ? null
                            : visits.stream().map(SoapVisit::request).toList(),
                    drones == null ? null : List.copyOf(drones),
                    objective == null ? null : objective.request(),
                    seconds,
                    null,
                    wind == null ? null : wind.request());
        }
    }

    SoapPlan ask(Wish wish) {
        return SoapPlan.of(plans.ask(caller.reading(), wish.request()));
    }

    SoapPlan plan(String id) {
        return SoapPlan.of(plans.one(caller.reading(), id));
    }

    SoapPlan accept(String id, @Nullable Boolean start, @Nullable String onCloudLoss) {
        return SoapPlan.of(plans.accept(
                        new Caller(caller.reading(), "soap"),
                        id,
                        new PlanRequest.AcceptRequest(start, onCloudLoss),
                        LONGEST_WAIT)
                .join());
    }

    SoapPlan stop(String id) {
        return SoapPlan.of(plans.stop(caller.principal(), id));
    }

    void cancel(String id) {
        plans.remove(caller.reading(), id);
    }
}

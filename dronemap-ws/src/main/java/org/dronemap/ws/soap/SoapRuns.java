package org.dronemap.ws.soap;

import java.util.List;
import org.dronemap.ws.service.RunRequest;
import org.dronemap.ws.service.RunService;
import org.jspecify.annotations.Nullable;

/** Mission runs over SOAP. Any thread. */
public final class SoapRuns {
    private final SoapCaller caller;
    private final RunService runs;

    public SoapRuns(SoapCaller caller, RunService runs) {
        this.caller = caller;
        this.runs = runs;
    }

    SoapRun start(String plan, @Nullable String mode, @Nullable String onCloudLoss, @Nullable String name) {
        return SoapRun.of(
                runs.start(caller.reading(), new RunRequest.StartRequest(plan, mode, onCloudLoss, name, null)));
    }

    List<SoapRun> all() {
        return runs.all(caller.reading()).stream().map(SoapRun::of).toList();
    }

    SoapRun run(String id) {
        return SoapRun.of(runs.one(caller.reading(), id));
    }

    SoapRun add(String id, @Nullable List<SoapVisit> visits) {
        RunRequest.WaypointsRequest request = new RunRequest.WaypointsRequest(
                visits == null ? null : visits.stream().map(SoapVisit::request).toList());
        return SoapRun.of(runs.add(caller.reading(), id, request));
    }

    SoapRun resume(String id, @Nullable String drone) {
        return SoapRun.of(runs.resume(caller.principal(), id, drone == null ? "" : drone));
    }

    /** A missing number is told like any other that does not fit, to who may answer. */
    SoapRun answer(String id, @Nullable Integer proposal, @Nullable Boolean accept) {
        String number = proposal == null ? "" : proposal.toString();
        return SoapRun.of(runs.answer(caller.principal(), id, number, new RunRequest.AnswerRequest(accept)));
    }

    SoapRun pause(String id) {
        return SoapRun.of(runs.pause(caller.principal(), id));
    }

    SoapRun goOn(String id) {
        return SoapRun.of(runs.goOn(caller.principal(), id));
    }

    SoapRun stop(String id) {
        return SoapRun.of(runs.stop(caller.principal(), id));
    }
}

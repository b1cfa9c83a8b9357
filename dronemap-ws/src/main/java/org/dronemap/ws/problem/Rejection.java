package org.dronemap.ws.problem;

import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import org.dronemap.core.command.OutcomeCode;
import org.dronemap.core.command.Refusal;
import org.dronemap.core.drone.DroneId;
import org.dronemap.core.lease.ControlState;
import org.dronemap.core.lease.Lease;
import org.jspecify.annotations.Nullable;

/** Exception that refuses a request with a problem code and a sentence; each face maps it to its own form. */
public class Rejection extends RuntimeException {
    private static final long serialVersionUID = 1L;

    @SuppressWarnings("serial") // rejections stay within the process
    private final ProblemCode code;

    @SuppressWarnings("serial")
    private final List<ProblemParameter.Given> parameters;

    private final @Nullable String commandId;
    private final @Nullable String holder;
    private final @Nullable Instant heldSince;

    Rejection(ProblemCode code, String sentence, List<ProblemParameter.Given> parameters) {
        this(code, sentence, parameters, null, null);
    }

    private Rejection(
            ProblemCode code,
            String sentence,
            List<ProblemParameter.Given> parameters,
            @Nullable String commandId,
            @Nullable Lease tenure) {
        super(sentence, null, false, false);
        code.entry().check(parameters);
        this.code = code;
        this.parameters = List.copyOf(parameters);
        this.commandId = commandId;
        this.holder = tenure == null ? null : tenure.holder().label().orElse(null);
        this.heldSince = tenure == null ? null : since(tenure);
    }

    /** With what the catalogue declares for that code. */
    public static Rejection of(ProblemCode code, String sentence, ProblemParameter.Given... parameters) {
        return new Rejection(code, sentence, List.of(parameters));
    }

    public static Rejection unknown(NotFoundProblem code, String id) {
        return of(code, code.sentence(id), code.id().is(id));
    }

    /** There was a session, which is no longer known. */
    public static Rejection sessionEnded() {
        return of(
                AccessProblem.SESSION_ENDED,
                "This session has ended: after 12 hours, or because the account was changed or the stored data were"
                        + " restored. Sign in again.");
    }

    /** Somebody else has control. */
    public static Rejection held(String sentence, DroneId drone, ControlState control) {
        return refused(new Refusal(OutcomeCode.CONTROL_HELD, sentence), drone, null, control);
    }

    /** Control does not change as somebody asked. */
    public static Rejection ofControl(ProblemCode code, String sentence, DroneId drone, ControlState control) {
        return ofDrone(code, sentence, drone, null, control);
    }

    /**
     * A command, or a setpoint, that the gate refused.
     *
     * @param commandId whose record can be looked up; null: of a setpoint
     * @param control who has control now, which is told where that is why
     */
    public static Rejection refused(Refusal why, DroneId drone, @Nullable String commandId, ControlState control) {
        return ofDrone(new CommandProblem(why.code()), why.sentence(), drone, commandId, control);
    }

    private static Rejection ofDrone(
            ProblemCode code, String sentence, DroneId drone, @Nullable String commandId, ControlState control) {
        List<ProblemParameter.Given> parameters = new ArrayList<>();
        parameters.add(ProblemParameter.DRONE.is(drone.value()));
        if (commandId != null) {
            parameters.add(ProblemParameter.COMMAND.is(commandId));
        }
        Lease tenure = code.entry().optional().contains(ProblemParameter.HOLDER) ? control.tenure() : null;
        if (tenure != null) {
            tenure.holder().label().ifPresent(holder -> parameters.add(ProblemParameter.HOLDER.is(holder)));
            parameters.add(ProblemParameter.HELD_SINCE.is(since(tenure).toString()));
        }
        return new Rejection(code, sentence, parameters, commandId, tenure);
    }

    private static Instant since(Lease tenure) {
        return tenure.since().truncatedTo(ChronoUnit.MILLIS);
    }

    public ProblemCode code() {
        return code;
    }

    public RejectionKind kind() {
        return code.kind();
    }

    /** What the sentence is about, each once. */
    public List<ProblemParameter.Given> parameters() {
        return parameters;
    }

    public @Nullable String commandId() {
        return commandId;
    }

    /** The user who has control; null where that is not why, or nobody has. */
    public @Nullable String holder() {
        return holder;
    }

    /** Since when somebody has control; null where that is not why. */
    public @Nullable Instant heldSince() {
        return heldSince;
    }

    /** The sentence for people. */
    public String sentence() {
        String message = getMessage();
        return message == null ? kind().title() : message;
    }
}
